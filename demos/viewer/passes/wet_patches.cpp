#include "viewer/passes/wet_patches.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include "checks/text.h"
#include "viewer/passes/shader_values.h"
#include "viewer/shaders/shaders.h"

namespace drench::viewer {

namespace {

void requireComplete() {
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        throw std::runtime_error(
            textOf("viewer: the graphics driver cannot provide a map of wet patches "
                   "(framebuffer status ",
                   status, "); ask for a smaller picture or update the driver"));
    }
}

bool isDrawable(const WetPatch& patch) {
    return viewer::isDrawable(patch.centre) && viewer::isDrawable(patch.radius) && patch.wetness > 0.0f &&
           patch.orientation.coeffs().allFinite();
}

}  // namespace

WetPatches::Maps::Maps(int mapWidth, int mapHeight) : width(mapWidth), height(mapHeight) {
    store(depth, {width, height, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_FLOAT}, GL_NEAREST, GL_NEAREST,
          GL_CLAMP_TO_EDGE);
    store(wetness, {width, height, GL_R8, GL_RED, GL_UNSIGNED_BYTE}, GL_NEAREST, GL_NEAREST,
          GL_CLAMP_TO_EDGE);
    glBindFramebuffer(GL_FRAMEBUFFER, solids.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth.name(), 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    requireComplete();
    glBindFramebuffer(GL_FRAMEBUFFER, patches.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, wetness.name(), 0);
    requireComplete();
}

WetPatches::WetPatches()
    : program_(
          "wet patch", {shaders::frame, shaders::patchVertex},
          {shaders::frame, shaders::noise, shaders::placeBehind, shaders::turning, shaders::patchFragment}) {
    constexpr std::uint8_t none[4] = {0, 0, 0, 0};
    store(dry_, {1, 1, GL_R8, GL_RED, GL_UNSIGNED_BYTE}, GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE, none);
}

void WetPatches::upload(const std::vector<WetPatch>& patches) {
    std::vector<InstancedQuads<3>::Instance> instances;
    for (const WetPatch& patch : patches) {
        if (isDrawable(patch))
            instances.push_back({{packed(patch.centre, patch.radius),
                                  packed(patch.orientation),
                                  {std::min(patch.wetness, 1.0f), patch.outline, 0.0f, 0.0f}}});
    }
    quads_.upload(instances);
}

void WetPatches::beginSolids(int width, int height) {
    if (!maps_ || maps_->width != width || maps_->height != height) {
        // Frees the old memory before allocating the new.
        maps_.reset();
        maps_.emplace(width, height);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, maps_->solids.name());
    glViewport(0, 0, width, height);
    glClear(GL_DEPTH_BUFFER_BIT);
}

void WetPatches::drawOntoSolids() const {
    glBindFramebuffer(GL_FRAMEBUFFER, maps_->patches.name());
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    glActiveTexture(GL_TEXTURE3);
    glBindTexture(GL_TEXTURE_2D, maps_->depth.name());
    glActiveTexture(GL_TEXTURE0);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    // Overlapping patches are wetter, and their edges merge.
    glBlendFunc(GL_ONE, GL_ONE);
    program_.use();
    quads_.draw();
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
}

void WetPatches::bindForLookup() const {
    glActiveTexture(GL_TEXTURE6);
    glBindTexture(GL_TEXTURE_2D, empty() || !maps_ ? dry_.name() : maps_->wetness.name());
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace drench::viewer
