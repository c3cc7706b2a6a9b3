// Pieces of GLSL source, of which the programs are put together; each is the file of its name beside this one.
#pragma once

namespace drench::viewer::shaders {

// Shared: the frame, its light, and what is looked up.
extern const char frame[], sky[], occlusion[], material[], noise[], turning[], placeBehind[];

// Ground, sky, and the way to the screen.
extern const char fullScreenVertex[], groundVertex[], groundFragment[], skyFragment[], depthFragment[],
    presentFragment[];

// What solids are made of, and what water on them does.
extern const char wetting[], solidMaterials[];

// Balls, rods and boxes.
extern const char ballVertex[], ballFragment[], rodVertex[], rodFragment[], boxVertex[], boxFragment[];

// Wet patches on solids.
extern const char patchVertex[], patchFragment[];

// The threads of a cloth.
extern const char relief[], threads[], cloth[], hem[];

// Sheets.
extern const char sheetBlock[], sheetVertex[], dye[], seeThrough[], sheetLight[], sheetFragment[],
    sheetLayerFragment[];

// What the sun's map keeps of sheets and solids.
extern const char sheetShadowFragment[], solidShadowFragment[];

// Standing water.
extern const char waterVertex[], waterFragment[];

// Drops, streaks and mist.
extern const char airborne[], sunInAir[], dropVertex[], dropFragment[], streakVertex[], streakFragment[],
    puffVertex[], puffFragment[];

}  // namespace drench::viewer::shaders
