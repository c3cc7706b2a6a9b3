// Pieces of GLSL source that make up the shader programs; each is the file of its name in this folder.
#pragma once

namespace drench::viewer::shaders {

// Common: frame, light, and texture lookups.
extern const char frame[], sky[], occlusion[], material[], noise[], turning[], placeBehind[];

// Ground, sky, and conversion to the screen.
extern const char fullScreenVertex[], groundVertex[], groundFragment[], skyFragment[], depthFragment[],
    presentFragment[];

// Materials of solids, and the effect of water on them.
extern const char wetting[], solidMaterials[];

// Balls, capsules and boxes.
extern const char ballVertex[], ballFragment[], rodVertex[], rodFragment[], boxVertex[], boxFragment[];

// Wet patches on solids.
extern const char patchVertex[], patchFragment[];

// The threads of a cloth.
extern const char relief[], threads[], cloth[], hem[];

// Sheets.
extern const char sheetRounding[], sheetBlock[], sheetVertex[], dye[], seeThrough[], sheetLight[],
    sheetFragment[], sheetLayerFragment[];

// Shadow map of sheets and solids.
extern const char sheetShadowFragment[], solidShadowFragment[];

// Pools.
extern const char waterVertex[], waterFragment[];

// Drops, streaks and mist.
extern const char airborne[], sunInAir[], dropVertex[], dropFragment[], streakVertex[], streakFragment[],
    puffVertex[], puffFragment[];

}  // namespace drench::viewer::shaders
