#include "viewer/passes/wet_patches.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include "checks/text.h"
#include "viewer/shaders/shaders.h"

namespace drench::viewer {

namespace {

void allocate(const Texture& texture, GLint format, int width, int height, GLenum channels, GLenum type,
              const void* values) {
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, channels, type, values);
    for (const auto filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
        glTexParameteri(GL_TEXTURE_2D, static_cast<GLenum>(filter), GL_NEAREST);
    }
    for (const auto direction : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
        glTexParameteri(GL_TEXTURE_2D, static_cast<GLenum>(direction), GL_CLAMP_TO_EDGE);
    }
}

void requireComplete() {
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        throw std::runtime_error(
            textOf("viewer: the graphics driver cannot provide a map of wet patches "
                   "(framebuffer status ",
                   status, "); ask for a smaller picture or update the driver"));
    }
}

bool drawable(const WetPatch& patch) {
    return patch.centre.allFinite() && patch.centre.cwiseAbs().maxCoeff() < 1e5f && patch.radius > 0.0f &&
           patch.radius < 1e5f && patch.wetness > 0.0f && patch.orientation.coeffs().allFinite();
}

}  // namespace

WetPatches::Maps::Maps(int mapWidth, int mapHeight) : width(mapWidth), height(mapHeight) {
    allocate(depth, GL_DEPTH_COMPONENT24, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    allocate(wetness, GL_R8, width, height, GL_RED, GL_UNSIGNED_BYTE, nullptr);
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
    allocate(dry_, GL_R8, 1, 1, GL_RED, GL_UNSIGNED_BYTE, none);
}

void WetPatches::upload(const std::vector<WetPatch>& patches) {
    std::vector<InstancedQuads<3>::Instance> instances;
    for (const WetPatch& patch : patches) {
        if (!drawable(patch)) {
            continue;
        }
        const auto& at = patch.centre;
        const auto& turn = patch.orientation;
        instances.push_back({{{at.x(), at.y(), at.z(), patch.radius},
                              {turn.x(), turn.y(), turn.z(), turn.w()},
                              {std::min(patch.wetness, 1.0f), patch.outline, 0.0f, 0.0f}}});
    }
    quads_.upload(instances);
}

void WetPatches::beginSolids(int width, int height) {
    if (!maps_ || maps_->width != width || maps_->height != height) {
        // Gives the old memory back before it asks for the new.
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
    // Where patches overlap they are wetter, and edges that meet run together.
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
