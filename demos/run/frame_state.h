// State of a simulation after a frame, for window and panel, which read it while the simulation continues.
#pragma once

#include <drench/moisture.h>

#include <optional>
#include <string>
#include <vector>

#include "description/scene_description.h"
#include "viewer/picture/picture.h"

namespace drench::demo {

// One sheet and its water.
struct SheetReading {
    std::string name;
    double dryMass = 0;     // of the cloth, kg
    double pores = 0;       // pore water, kg
    double film = 0;        // film water, kg
    double saturation = 0;  // mean of the sheet, 0 to 1
    double waterSpeed = 1;  // ratio of water time to the sheet's own time
    Ledger ledger;
};

// Computing times of a frame, s.
struct FrameTimes {
    double supply = 0;    // sources
    double water = 0;     // drying, absorption, wicking, film flow and dripping
    double laws = 0;      // masses and stiffness, computed from the water
    double air = 0;       // wind, and forces of air and water
    double contacts = 0;  // with solids and other sheets
    double solver = 0;    // links and bending, in small steps
    double all = 0;       // the whole frame, including everything else
};

// Created by the thread of the simulation, then constant.
struct FrameState {
    std::string scene;  // its name
    int run = 0;        // number of scenes made so far
    int frame = 0;      // number of simulated frames in this run
    double time = 0;    // simulated time in this run, s
    viewer::Picture picture;
    std::optional<viewer::Picture> dryPicture;  // of the dry copy that is shown beside it; none: no copy
    std::string status;
    double progress = 0;  // 0 to 1
    bool ended = false;   // whether the scene has ended; it may continue
    std::vector<SheetReading> sheets;
    std::optional<Weather> weather;  // none if the scene sets its own
    FrameTimes times;
    double framesPerSecond = 0;  // simulated frames per second of wall time
    std::string notice;          // result of the last request to save or change something; empty: none
    std::string trouble;         // why the simulation has stopped; empty if there is no error
};

}  // namespace drench::demo
