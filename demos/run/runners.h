// A scene run to its end without a window, and what it and a window both make and write.
#pragma once

#include "run/run_options.h"
#include "run/water_log.h"

namespace drench::demo {

// Makes the scene that the options name or describe.
// @throws std::invalid_argument as the functions of that name in registry.h
std::unique_ptr<Scene> makeScene(const RunOptions& options);

// The scene as it is now.
// @throws std::runtime_error for a scene that a scene file cannot hold
SceneDescription describedNow(Scene& scene);

// Writes the scene file that the options ask for: the scene as it is now.
// @throws std::runtime_error as `describedNow`, and for a file that cannot be written
void writeScene(const RunOptions& options, Scene& scene);

// Runs a scene to its end without a window: progress on stderr, the result on stdout and in files.
// @return the exit status: 0, 1 if the scene's check fails, or 2 if pictures, its film or what it exports is not whole
int runHeadless(Scene& scene, const RunOptions& options);

// Names a picture that is taken every so many frames: "frame-000123".
std::string frameName(int frame);

// Makes sure that what the options ask to be written can be written.
// @throws std::runtime_error that names what cannot
void checkTargets(const RunOptions& options);

// Writes the CSV file that the options ask for: the water of each frame. Where the scene has a result of its
// own, the file holds that, and the water is in a file beside it whose name ends in "-water".
void writeResult(const RunOptions& options, const Scene& scene, const WaterLog& log);

// Writes the images that the scene makes itself into the folder for pictures, if the options name one.
void writeDrawings(const RunOptions& options, const Scene& scene);

}  // namespace drench::demo
