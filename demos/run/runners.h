// Runs a scene to its end without a window; and functions that are used with and without a window.
#pragma once

#include "run/run_options.h"
#include "run/water_log.h"

namespace drench::demo {

// Makes the scene that the options name or describe.
// @throws std::invalid_argument as the functions of that name in registry.h
std::unique_ptr<Scene> makeScene(const RunOptions& options);

// The scene in its present state.
// @throws std::runtime_error for a scene that cannot be described by a scene file
SceneDescription describedNow(Scene& scene);

// Writes the scene file that the options require: the scene in its present state.
// @throws std::runtime_error as `describedNow`, and for a file that cannot be written
void writeScene(const RunOptions& options, Scene& scene);

// Runs a scene to its end without a window: progress on stderr, the result on stdout and in files.
// @return the exit status: 0, 1 if the scene's check fails, or 2 if pictures, video or export are incomplete
int runHeadless(Scene& scene, const RunOptions& options);

// Name of a picture that is taken at regular intervals: "frame-000123".
std::string frameName(int frame);

// Checks that all files in the options can be written.
// @throws std::runtime_error that names the one that cannot
void checkTargets(const RunOptions& options);

// Writes the CSV file that the options require: the water of each frame. If the scene has a result table, the
// file contains that table, and the water is written to a second file whose name ends in "-water".
void writeResult(const RunOptions& options, const Scene& scene, const WaterLog& log);

// Writes the images that the scene itself makes to the folder for pictures, if the options name one.
void writeDrawings(const RunOptions& options, const Scene& scene);

}  // namespace drench::demo
