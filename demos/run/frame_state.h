// A simulation as it was after a frame, for eyes and panel to look at while it goes on.
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
    double pores = 0;       // water in its pores, kg
    double film = 0;        // water on its faces, kg
    double saturation = 0;  // mean of the sheet, 0 to 1
    double waterSpeed = 1;  // how much faster water runs than the sheet's own time
    Ledger ledger;
};

// What a frame took, s.
struct FrameTimes {
    double supply = 0;    // sources bring their water
    double water = 0;     // drying, soaking in, wicking, running down and dripping
    double laws = 0;      // masses and stiffness follow from the water
    double air = 0;       // wind, and what air and water push
    double contacts = 0;  // with solids and other sheets
    double solver = 0;    // links and bending, in small steps
    double all = 0;       // the whole frame, with what none of these names
};

// Made by the thread of the simulation, changed by nobody.
struct FrameState {
    std::string scene;  // its name
    int run = 0;        // counts the scenes made so far
    int frame = 0;      // simulated in this run
    double time = 0;    // s simulated in this run
    viewer::Picture picture;
    std::optional<viewer::Picture> dryPicture;  // of the dry twin, to show beside it; none: it runs alone
    std::string status;
    double progress = 0;  // 0 to 1
    bool ended = false;   // the scene has come to its end, and plays on
    std::vector<SheetReading> sheets;
    std::optional<Weather> weather;  // none where the scene makes its own
    FrameTimes times;
    double framesPerSecond = 0;  // simulated in a second of wall time, lately
    std::string notice;          // of the last request to save or to change something; empty: none
    std::string trouble;         // why it stands still; empty if all is well
};

}  // namespace drench::demo
