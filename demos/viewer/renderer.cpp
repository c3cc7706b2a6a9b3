#include "viewer/renderer.h"

#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "checks/text.h"
#include "viewer/gl/gl_error_count.h"
#include "viewer/gl/render_target.h"
#include "viewer/passes/airborne_water.h"
#include "viewer/passes/background_pass.h"
#include "viewer/passes/frame_uniforms.h"
#include "viewer/passes/sheet_pass.h"
#include "viewer/passes/solid_pass.h"
#include "viewer/passes/water_pass.h"
#include "viewer/passes/wet_patches.h"
#include "viewer/shaders/shaders.h"
#include "viewer/text/caption.h"

namespace drench::viewer {

namespace {

void requireOpenGl33() {
    const int version = epoxy_gl_version();
    if (version == 0 || !epoxy_is_desktop_gl()) {
        throw std::runtime_error(
            "viewer: no OpenGL context is current; make an OffscreenContext or a Window first");
    }
    if (version < 33) {
        throw std::runtime_error(textOf("viewer: OpenGL 3.3 is needed, but this context has ", version / 10,
                                        ".", version % 10, "; update the graphics driver"));
    }
}

void requireDrawable(const Picture& picture) {
    picture.camera.check();
    if (!picture.towardsSun.allFinite() || !(picture.towardsSun.norm() > 1e-6f))
        throw std::runtime_error(textOf("viewer: towardsSun is ", picture.towardsSun,
                                        "; give finite numbers, and a vector longer than 0"));
    if (!(picture.sunshine >= 0.0f && picture.sunshine <= 1.0f))
        throw std::runtime_error(textOf("viewer: sunshine is ", picture.sunshine, "; give 0 to 1"));
    if (!std::isfinite(picture.groundHeight))
        throw std::runtime_error(
            textOf("viewer: groundHeight is ", picture.groundHeight, " m; give a finite number"));
}

// ImGui and the caller may have left any state.
void setPlainState() {
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
}

bool groundIsSeen(const FrameUniforms& uniforms) {
    return uniforms.eye[1] > uniforms.ground[0];
}

}  // namespace

class Renderer::Passes {
  public:
    Passes() = default;

    void draw(const Picture& picture, const Area& area, unsigned framebuffer);
    void drawPair(const Picture& left, const Picture& right, int width, int height, unsigned framebuffer);
    int glErrors() const { return errors_.count(); }

  private:
    void resize(int width, int height);
    // Returns points that enclose everything that casts a shadow.
    std::vector<Eigen::Vector3f> upload(const Picture& picture);
    void drawShadows(const FrameUniforms& uniforms) const;
    void drawWetness(const FrameUniforms& uniforms);
    void drawScene(const FrameUniforms& uniforms) const;
    void present(unsigned framebuffer, const Area& area) const;

    GlErrorCount errors_;
    FrameBlock frameBlock_;
    VertexArray noAttributes_;
    ShaderProgram present_{"present", {shaders::fullScreenVertex}, {shaders::presentFragment}};
    ShadowTarget shadow_{2048};
    SolidPass solids_;
    BackgroundPass background_;
    SheetPass sheets_;
    WaterPass waters_;
    WetPatches patches_;
    AirborneWater airborne_;
    std::optional<SceneTarget> target_;
    std::optional<LayersTarget> layers_;
    Caption caption_;
};

std::vector<Eigen::Vector3f> Renderer::Passes::upload(const Picture& picture) {
    std::vector<Eigen::Vector3f> casters;
    solids_.upload(picture, casters);
    sheets_.upload(picture, casters);
    waters_.upload(picture.waters);
    patches_.upload(picture.patches);
    airborne_.upload(picture);
    return casters;
}

void Renderer::Passes::drawShadows(const FrameUniforms& uniforms) const {
    frameBlock_.bind(uniforms);
    shadow_.begin();
    sheets_.round();
    // Solids first: behind them there is no sunlight, with or without sheets.
    solids_.drawShadows();
    sheets_.drawShadows();
    shadow_.end();
}

void Renderer::Passes::drawWetness(const FrameUniforms& uniforms) {
    if (patches_.empty()) return;
    frameBlock_.bind(uniforms);
    patches_.beginSolids(target_->width(), target_->height());
    solids_.drawDepth();
    background_.drawDepth(groundIsSeen(uniforms));
    patches_.drawOntoSolids();
}

void Renderer::Passes::drawScene(const FrameUniforms& uniforms) const {
    target_->bind();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    frameBlock_.bind(uniforms);
    shadow_.bindForLookup();
    patches_.bindForLookup();
    solids_.draw();
    background_.draw(groundIsSeen(uniforms));
    if (!sheets_.empty()) {
        target_->resolveForBlurredLookup();
        layers_->begin();
        sheets_.drawLayers();
        layers_->end();
        target_->bind();
        sheets_.draw();
    }
    if (!waters_.empty()) {
        target_->resolveForLookup();
        waters_.draw();
    }
    if (!airborne_.empty()) {
        target_->resolveForLookup();
        airborne_.draw();
    }
    shadow_.unbind();
}

void Renderer::Passes::present(unsigned framebuffer, const Area& area) const {
    target_->resolve();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(area.x, area.y, area.width, area.height);
    glDisable(GL_DEPTH_TEST);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, target_->texture());
    glBindVertexArray(noAttributes_.name());
    present_.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glActiveTexture(GL_TEXTURE0);
}

void Renderer::Passes::resize(int width, int height) {
    if (!target_ || target_->width() != width || target_->height() != height) {
        // Frees the old memory before allocating the new.
        target_.reset();
        layers_.reset();
        target_.emplace(width, height);
        layers_.emplace(width, height);
    }
}

void Renderer::Passes::draw(const Picture& picture, const Area& area, unsigned framebuffer) {
    requireDrawable(picture);
    resize(area.width, area.height);
    const std::vector<Eigen::Vector3f> casters = upload(picture);
    const ShadowFit shadow = fitShadow(casters, picture.towardsSun.normalized(), shadow_.resolution());
    const FrameUniforms uniforms =
        cameraUniforms(picture, drawable(picture.balls), area.width, area.height, shadow);

    setPlainState();
    drawShadows(sunUniforms(uniforms, shadow));
    drawWetness(uniforms);
    drawScene(uniforms);
    present(framebuffer, area);
    caption_.draw(picture, area);
    errors_.poll();
}

void Renderer::Passes::drawPair(const Picture& left, const Picture& right, int width, int height,
                                unsigned framebuffer) {
    const AreaPair areas = sideBySide(width, height);
    draw(left, areas.left, framebuffer);
    draw(right, areas.right, framebuffer);
    // The line between the pictures.
    constexpr std::array<float, 4> paleGrey{0.85f, 0.85f, 0.85f, 1.0f};
    glEnable(GL_SCISSOR_TEST);
    glScissor(areas.left.width, 0, areas.right.x - areas.left.width, height);
    glClearBufferfv(GL_COLOR, 0, paleGrey.data());
    glDisable(GL_SCISSOR_TEST);
}

Renderer::Renderer() {
    requireOpenGl33();
    passes_ = std::make_unique<Passes>();
}

Renderer::~Renderer() = default;

void Renderer::draw(const Picture& picture, int width, int height, unsigned framebuffer) {
    draw(picture, {0, 0, width, height}, framebuffer);
}

void Renderer::draw(const Picture& picture, const Area& area, unsigned framebuffer) {
    if (area.width > 0 && area.height > 0) passes_->draw(picture, area, framebuffer);
}

void Renderer::drawPair(const Picture& left, const Picture& right, int width, int height,
                        unsigned framebuffer) {
    if (sideBySide(width, height).left.width > 0) passes_->drawPair(left, right, width, height, framebuffer);
}

Image Renderer::capture(const Picture& picture, int width, int height) {
    const ImageTarget target(width, height);
    draw(picture, width, height, target.framebuffer());
    return target.read();
}

Image Renderer::capturePair(const Picture& left, const Picture& right, int width, int height) {
    const ImageTarget target(width, height);
    drawPair(left, right, width, height, target.framebuffer());
    return target.read();
}

int Renderer::glErrors() const {
    return passes_->glErrors();
}

}  // namespace drench::viewer
