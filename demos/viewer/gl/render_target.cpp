#include "viewer/gl/render_target.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "checks/text.h"

namespace drench::viewer {

namespace {

void requireComplete(const std::string& what, int width, int height) {
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        throw std::runtime_error(textOf("viewer: the graphics driver cannot provide ", what, " of ", width,
                                        " x ", height, " pixels (framebuffer status ", status,
                                        "); ask for a smaller picture or update the driver"));
    }
}

void requireSize(int width, int height) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (width < 1 || height < 1 || width > largest || height > largest) {
        throw std::runtime_error(textOf("viewer: a picture of ", width, " x ", height,
                                        " pixels is not possible; each side must be from 1 to ", largest));
    }
}

GLint smoothingSamples() {
    GLint max = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &max);
    return std::min(4, max);
}

void allocate(const Renderbuffer& renderbuffer, GLint samples, GLenum format, int width, int height) {
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
}

}  // namespace

SceneTarget::SceneTarget(int width, int height) : width_(width), height_(height) {
    requireSize(width, height);
    const GLint samples = smoothingSamples();
    // Half floats avoid visible steps in dark areas of linear light.
    allocate(colour_, samples, GL_RGBA16F, width, height);
    allocate(depth_, samples, GL_DEPTH_COMPONENT24, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
    requireComplete("a smoothed picture", width, height);

    store(resolvedColour_, {width, height, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT}, GL_LINEAR_MIPMAP_LINEAR,
          GL_LINEAR, GL_CLAMP_TO_EDGE);
    constexpr GLint coarsest = 6;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, coarsest);
    glGenerateMipmap(GL_TEXTURE_2D);
    store(resolvedDepth_, {width, height, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_FLOAT}, GL_NEAREST,
          GL_NEAREST, GL_REPEAT);
    glBindFramebuffer(GL_FRAMEBUFFER, resolved_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, resolvedColour_.name(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, resolvedDepth_.name(), 0);
    requireComplete("a resolved picture", width, height);
}

void SceneTarget::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, width_, height_);
}

void SceneTarget::resolve() const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.name());
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void SceneTarget::resolveForLookup() const {
    resolve();
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    glActiveTexture(GL_TEXTURE3);
    glBindTexture(GL_TEXTURE_2D, resolvedDepth_.name());
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, resolvedColour_.name());
    glActiveTexture(GL_TEXTURE0);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
}

void SceneTarget::resolveForBlurredLookup() const {
    resolveForLookup();
    glActiveTexture(GL_TEXTURE1);
    glGenerateMipmap(GL_TEXTURE_2D);
    glActiveTexture(GL_TEXTURE0);
}

ImageTarget::ImageTarget(int width, int height) : width_(width), height_(height) {
    requireSize(width, height);
    allocate(colour_, 0, GL_RGBA8, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_.name());
    requireComplete("an image", width, height);
}

Image ImageTarget::read() const {
    const std::size_t row = 3 * static_cast<std::size_t>(width_);
    std::vector<std::uint8_t> bottomFirst(row * static_cast<std::size_t>(height_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, bottomFirst.data());
    Image image{width_, height_, {}};
    image.rgb.reserve(bottomFirst.size());
    for (auto end = bottomFirst.end(); end != bottomFirst.begin(); end -= static_cast<std::ptrdiff_t>(row))
        image.rgb.insert(image.rgb.end(), end - static_cast<std::ptrdiff_t>(row), end);
    return image;
}

ShadowTarget::ShadowTarget(int resolution) : resolution_(resolution) {
    // Everything outside the map is lit.
    store(depth_, {resolution, resolution, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_FLOAT}, GL_LINEAR,
          GL_LINEAR, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    constexpr std::array<float, 4> farAway{1.0f, 1.0f, 1.0f, 1.0f};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, farAway.data());
    glSamplerParameteri(plain_.name(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(plain_.name(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glSamplerParameteri(plain_.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glSamplerParameteri(plain_.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glSamplerParameterfv(plain_.name(), GL_TEXTURE_BORDER_COLOR, farAway.data());
    glSamplerParameteri(plain_.name(), GL_TEXTURE_COMPARE_MODE, GL_NONE);
    store(passing_, {resolution, resolution, GL_RG16, GL_RG, GL_UNSIGNED_SHORT}, GL_NEAREST, GL_NEAREST,
          GL_CLAMP_TO_EDGE);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.name(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, passing_.name(), 0);
    requireComplete("a shadow map", resolution, resolution);
}

void ShadowTarget::begin() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, resolution_, resolution_);
    constexpr std::array<float, 4> nothingInTheWay{1.0f, 1.0f, 1.0f, 1.0f};
    glClearBufferfv(GL_COLOR, 0, nothingInTheWay.data());
    glClearBufferfv(GL_DEPTH, 0, nothingInTheWay.data());
    glEnable(GL_BLEND);
    glBlendEquation(GL_MIN);
}

void ShadowTarget::end() const {
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
}

void ShadowTarget::bindForLookup() const {
    glActiveTexture(GL_TEXTURE4);
    glBindTexture(GL_TEXTURE_2D, passing_.name());
    glActiveTexture(GL_TEXTURE2);
    glBindTexture(GL_TEXTURE_2D, depth_.name());
    glBindSampler(2, plain_.name());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, depth_.name());
    glBindSampler(0, 0);
}

LayersTarget::LayersTarget(int width, int height) : width_(width), height_(height) {
    store(product_, {width, height, GL_R8, GL_RED, GL_UNSIGNED_BYTE}, GL_NEAREST, GL_NEAREST, GL_REPEAT);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, product_.name(), 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw std::runtime_error(
            "viewer: the graphics driver cannot draw into one channel of 8 bits; update it");
    }
}

void LayersTarget::begin() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, width_, height_);
    constexpr std::array<float, 4> allPasses{1.0f, 1.0f, 1.0f, 1.0f};
    glClearBufferfv(GL_COLOR, 0, allPasses.data());
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
}

void LayersTarget::end() const {
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glActiveTexture(GL_TEXTURE5);
    glBindTexture(GL_TEXTURE_2D, product_.name());
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace drench::viewer
