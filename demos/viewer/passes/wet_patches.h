// Map of the wet pixels of solids and ground.
#pragma once

#include <optional>
#include <vector>

#include "viewer/gl/instanced_quads.h"
#include "viewer/gl/shader_program.h"
#include "viewer/picture/picture.h"

namespace drench::viewer {

// A map of the wet patches as the camera sees them, one value for each pixel, which the shaders of solids
// look up.
class WetPatches {
  public:
    // Throws std::runtime_error when the driver refuses a shader.
    WetPatches();

    // Replaces the patches; leaves out those that are not finite, have no size or are dry.
    void upload(const std::vector<WetPatch>& patches);
    bool empty() const { return quads_.empty(); }

    // Prepares the depth buffer for surfaces that can be wet, in a picture of this size, for the following
    // draw calls.
    // Throws std::runtime_error when the driver cannot provide it.
    void beginSolids(int width, int height);
    // Draws the patches onto that depth. The frame's uniforms must be bound.
    void drawOntoSolids() const;
    // Binds the map to texture unit 6, or a dry one if there are no patches.
    void bindForLookup() const;

  private:
    struct Maps {
        Maps(int width, int height);
        int width;
        int height;
        Texture depth;
        Texture wetness;
        Framebuffer solids;
        Framebuffer patches;
    };

    ShaderProgram program_;
    InstancedQuads<3> quads_;
    std::optional<Maps> maps_;
    Texture dry_;
};

}  // namespace drench::viewer
