// The two ways to run a scene.
#pragma once

#include "run_options.h"

namespace drench::demo {

/// Runs a scene to its end without a window: progress on stderr, the result on stdout and in files.
/// @return the exit status: 0, or 1 if the scene's check fails
int runHeadless(Scene& scene, const RunOptions& options);

/// Makes the scene that the options name and runs it in a window until that is closed.
/// @return the exit status
int runInWindow(const RunOptions& options);

/// Makes sure that what the options ask to be written can be written.
/// @throws std::runtime_error that names what cannot
void checkTargets(const RunOptions& options);

/// Writes the CSV file that the options ask for.
void writeResult(const RunOptions& options, const Scene& scene);

}  // namespace drench::demo
