#include "viewer/renderer.h"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "viewer/airborne_water.h"
#include "viewer/background_pass.h"
#include "viewer/caption.h"
#include "viewer/frame_uniforms.h"
#include "viewer/gl_error_count.h"
#include "viewer/render_target.h"
#include "viewer/shaders_background.h"
#include "viewer/sheet_pass.h"
#include "viewer/solid_pass.h"
#include "viewer/water_pass.h"
#include "viewer/wet_patches.h"

namespace drench::viewer {

namespace {

void requireOpenGl33() {
    const int version = epoxy_gl_version();
    if (version == 0 || !epoxy_is_desktop_gl()) {
        throw std::runtime_error(
            "viewer: no OpenGL context is current; make an OffscreenContext or a Window first");
    }
    if (version < 33) {
        throw std::runtime_error("viewer: OpenGL 3.3 is needed, but this context has " +
                                 std::to_string(version / 10) + "." + std::to_string(version % 10) +
                                 "; update the graphics driver");
    }
}

void requireDrawable(const Picture& picture) {
    picture.camera.check();
    if (!picture.towardsSun.allFinite() || !(picture.towardsSun.norm() > 1e-6f)) {
        throw std::runtime_error("viewer: towardsSun must be finite and longer than 0");
    }
    if (!std::isfinite(picture.groundHeight)) {
        throw std::runtime_error("viewer: groundHeight must be finite");
    }
}

// ImGui and the caller may have left anything behind.
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

class Renderer::Scene {
  public:
    Scene() = default;

    void draw(const Picture& picture, int width, int height, unsigned framebuffer);
    Image capture(const Picture& picture, int width, int height);
    int glErrors() const { return errors_.count(); }

  private:
    void resize(int width, int height);
    // Returns points that surround all that casts a shadow.
    std::vector<Eigen::Vector3f> upload(const Picture& picture);
    void drawShadows(const FrameUniforms& uniforms) const;
    void drawWetness(const FrameUniforms& uniforms);
    void drawScene(const FrameUniforms& uniforms) const;
    void present(unsigned framebuffer, int width, int height) const;

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
    Caption caption_;
};

std::vector<Eigen::Vector3f> Renderer::Scene::upload(const Picture& picture) {
    std::vector<Eigen::Vector3f> casters;
    solids_.upload(picture, casters);
    sheets_.upload(picture, casters);
    waters_.upload(picture.waters);
    patches_.upload(picture.patches);
    airborne_.upload(picture);
    return casters;
}

void Renderer::Scene::drawShadows(const FrameUniforms& uniforms) const {
    frameBlock_.bind(uniforms);
    shadow_.begin();
    // Solids first: what lies behind one of them lets no sun through, sheet or not.
    solids_.drawShadows();
    sheets_.drawShadows();
    shadow_.end();
}

void Renderer::Scene::drawWetness(const FrameUniforms& uniforms) {
    if (patches_.empty()) {
        return;
    }
    frameBlock_.bind(uniforms);
    patches_.beginSolids(target_->width(), target_->height());
    solids_.drawDepth();
    background_.drawDepth(groundIsSeen(uniforms));
    patches_.drawOntoSolids();
}

void Renderer::Scene::drawScene(const FrameUniforms& uniforms) const {
    target_->bind();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    frameBlock_.bind(uniforms);
    shadow_.bindForLookup();
    patches_.bindForLookup();
    solids_.draw();
    background_.draw(groundIsSeen(uniforms));
    if (!sheets_.empty()) {
        target_->resolveForBlurredLookup();
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

void Renderer::Scene::present(unsigned framebuffer, int width, int height) const {
    target_->resolve();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width, height);
    glDisable(GL_DEPTH_TEST);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, target_->texture());
    glBindVertexArray(noAttributes_.name());
    present_.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glActiveTexture(GL_TEXTURE0);
}

void Renderer::Scene::resize(int width, int height) {
    if (!target_ || target_->width() != width || target_->height() != height) {
        // Gives the old memory back before it asks for the new.
        target_.reset();
        target_.emplace(width, height);
    }
}

void Renderer::Scene::draw(const Picture& picture, int width, int height, unsigned framebuffer) {
    requireDrawable(picture);
    resize(width, height);
    const std::vector<Eigen::Vector3f> casters = upload(picture);
    const ShadowFit shadow = fitShadow(casters, picture.towardsSun.normalized(), shadow_.resolution());
    const FrameUniforms uniforms =
        cameraUniforms(picture, drawableBalls(picture.balls), width, height, shadow);

    setPlainState();
    drawShadows(sunUniforms(uniforms, shadow));
    drawWetness(uniforms);
    drawScene(uniforms);
    present(framebuffer, width, height);
    caption_.draw(picture.caption, width, height, picture.captionBelow);
    errors_.poll();
}

Image Renderer::Scene::capture(const Picture& picture, int width, int height) {
    const ImageTarget target(width, height);
    draw(picture, width, height, target.framebuffer());
    return target.read();
}

Renderer::Renderer() {
    requireOpenGl33();
    scene_ = std::make_unique<Scene>();
}

Renderer::~Renderer() = default;

void Renderer::draw(const Picture& picture, int width, int height, unsigned framebuffer) {
    if (width > 0 && height > 0) {
        scene_->draw(picture, width, height, framebuffer);
    }
}

Image Renderer::capture(const Picture& picture, int width, int height) {
    return scene_->capture(picture, width, height);
}

int Renderer::glErrors() const {
    return scene_->glErrors();
}

}  // namespace drench::viewer
