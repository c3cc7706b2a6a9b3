// The command line of drench-demo.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "stage/scene.h"

namespace drench::demo {

constexpr int pictureWidth = 1280, pictureHeight = 720;  // of pictures and films, pixels

// How to run which scene.
struct RunOptions {
    std::string scene;                          // a name on the list, or that of the scene file
    std::optional<SceneDescription> described;  // what the scene file says; none: a scene on the list
    SceneOptions sceneOptions;
    bool headless = false;
    std::filesystem::path csv;     // empty: no file
    std::filesystem::path saved;   // scene file for the state at the end; empty: none
    View view = View::beauty;      // what pictures show of the sheets, in the window at first
    std::filesystem::path frames;  // folder for pictures; empty: none
    std::pair<int, int> windowSize{pictureWidth, pictureHeight};  // in screen coordinates
    double speed = 1;        // simulated time over wall time, in the window, at most; 0: as fast as it can
    bool paused = false;     // the window's scene stands still until it is told to go on
    bool quitAtEnd = false;  // closes the window when the scene has come to its end
    std::filesystem::path record;  // film to make; empty: none
    std::filesystem::path
        exported;          // what the sheets go into, frame by frame: .glb, .obj or .csv; empty: nothing
    bool timings = false;  // says when the first picture came, and how many a second
    std::chrono::steady_clock::time_point started = std::chrono::steady_clock::now();  // of the program
    int every = 0;  // a picture each so many frames; 0: at the scene's own moments
};

// What the command line asks for, or the exit status at once: 0 after --help or --list, 2 for arguments that
// are off, with the reason on stderr.
struct ParsedOptions {
    RunOptions options;
    std::optional<int> exitStatus;
};

ParsedOptions parseOptions(int argc, char** argv);

}  // namespace drench::demo
