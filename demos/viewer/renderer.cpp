#include "viewer/renderer.h"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "viewer/airborne_water.h"
#include "viewer/caption.h"
#include "viewer/frame_uniforms.h"
#include "viewer/gl_error_count.h"
#include "viewer/render_target.h"
#include "viewer/shader_program.h"
#include "viewer/shaders_background.h"
#include "viewer/shaders_lighting.h"
#include "viewer/shaders_materials.h"
#include "viewer/shaders_noise.h"
#include "viewer/shaders_sheet.h"
#include "viewer/shaders_solids.h"
#include "viewer/shaders_water.h"
#include "viewer/sheet_buffer.h"
#include "viewer/sheet_rounding.h"
#include "viewer/solids.h"
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

struct Programs {
    ShaderProgram sheet{"sheet",
                        {shaders::frame, shaders::sheetVertex},
                        {shaders::frame, shaders::sky, shaders::occlusion, shaders::material, shaders::noise,
                         shaders::weave, shaders::sheetFragment}};
    ShaderProgram ball{"ball",
                       {shaders::frame, shaders::ballVertex},
                       {shaders::frame, shaders::sky, shaders::occlusion, shaders::material, shaders::noise,
                        shaders::wetting, shaders::solidMaterials, shaders::ballFragment}};
    ShaderProgram rod{"rod",
                      {shaders::frame, shaders::rodVertex},
                      {shaders::frame, shaders::sky, shaders::occlusion, shaders::material, shaders::noise,
                       shaders::wetting, shaders::solidMaterials, shaders::rodFragment}};
    ShaderProgram box{"box",
                      {shaders::frame, shaders::boxVertex},
                      {shaders::frame, shaders::sky, shaders::occlusion, shaders::material, shaders::noise,
                       shaders::wetting, shaders::solidMaterials, shaders::boxFragment}};
    ShaderProgram water{"water",
                        {shaders::frame, shaders::waterVertex},
                        {shaders::frame, shaders::sky, shaders::occlusion, shaders::material, shaders::noise,
                         shaders::waterFragment}};
    ShaderProgram ground{"ground",
                         {shaders::frame, shaders::groundVertex},
                         {shaders::frame, shaders::sky, shaders::occlusion, shaders::material, shaders::noise,
                          shaders::wetting, shaders::groundFragment}};
    ShaderProgram sky{"sky",
                      {shaders::fullScreenVertex},
                      {shaders::frame, shaders::sky, shaders::noise, shaders::skyFragment}};
    ShaderProgram present{"present", {shaders::fullScreenVertex}, {shaders::presentFragment}};
    ShaderProgram sheetDepth{
        "sheet shadow", {shaders::frame, shaders::sheetVertex}, {shaders::depthFragment}};
    ShaderProgram ballDepth{"ball shadow", {shaders::frame, shaders::ballVertex}, {shaders::depthFragment}};
    ShaderProgram rodDepth{"rod shadow", {shaders::frame, shaders::rodVertex}, {shaders::depthFragment}};
    ShaderProgram boxDepth{"box shadow", {shaders::frame, shaders::boxVertex}, {shaders::depthFragment}};
    ShaderProgram groundDepth{
        "ground depth", {shaders::frame, shaders::groundVertex}, {shaders::depthFragment}};
};

void addCorners(std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& centre, float radius) {
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3f sign((corner & 1) != 0 ? 1.0f : -1.0f, (corner & 2) != 0 ? 1.0f : -1.0f,
                                   (corner & 4) != 0 ? 1.0f : -1.0f);
        points.push_back(centre + radius * sign);
    }
}

void addCorners(std::vector<Eigen::Vector3f>& points, const std::vector<Ball>& balls) {
    for (const Ball& ball : balls) {
        addCorners(points, ball.centre, ball.radius);
    }
}

void addCorners(std::vector<Eigen::Vector3f>& points, const std::vector<Rod>& rods) {
    for (const Rod& rod : rods) {
        addCorners(points, rod.from, rod.radius);
        addCorners(points, rod.to, rod.radius);
    }
}

void addCorners(std::vector<Eigen::Vector3f>& points, const std::vector<Box>& boxes) {
    for (const Box& box : boxes) {
        // However it is turned, it lies within the ball round its corners.
        addCorners(points, box.centre, box.halfExtents.norm());
    }
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
    // Returns the positions of the sheets that can be drawn.
    std::vector<Eigen::Vector3f> uploadSheets(const std::vector<SheetMesh>& sheets);
    void drawShadows(const FrameUniforms& uniforms) const;
    void drawSolidDepths() const;
    void drawGroundIfBelow(const FrameUniforms& uniforms, const ShaderProgram& program) const;
    void drawWetness(const FrameUniforms& uniforms);
    void drawScene(const FrameUniforms& uniforms);
    void present(unsigned framebuffer, int width, int height) const;

    GlErrorCount errors_;
    Programs programs_;
    FrameBlock frameBlock_;
    VertexArray noAttributes_;
    ShadowTarget shadow_{2048};
    Solids balls_{capsuleMesh(96, 24)};
    Solids rods_{capsuleMesh(20, 5)};
    Solids boxes_{boxMesh()};
    Solids waters_{boxMesh()};
    WetPatches patches_;
    AirborneWater airborne_;
    std::vector<SheetBuffer> sheets_;
    std::size_t sheetCount_ = 0;
    std::optional<SceneTarget> target_;
    Caption caption_;
};

std::vector<Eigen::Vector3f> Renderer::Scene::uploadSheets(const std::vector<SheetMesh>& sheets) {
    std::vector<Eigen::Vector3f> points;
    sheetCount_ = 0;
    for (const SheetMesh& sheet : sheets) {
        const auto vertices = sheetSurface(sheet);
        if (!vertices) {
            continue;
        }
        if (sheetCount_ == sheets_.size()) {
            sheets_.emplace_back();
        }
        sheets_[sheetCount_++].upload(rounded(*vertices, sheet.triangles));
        points.insert(points.end(), sheet.positions.begin(), sheet.positions.end());
    }
    return points;
}

void Renderer::Scene::drawShadows(const FrameUniforms& uniforms) const {
    shadow_.bind();
    glClear(GL_DEPTH_BUFFER_BIT);
    frameBlock_.bind(uniforms);
    programs_.sheetDepth.use();
    for (std::size_t i = 0; i < sheetCount_; ++i) {
        sheets_[i].draw();
    }
    drawSolidDepths();
}

void Renderer::Scene::drawSolidDepths() const {
    programs_.ballDepth.use();
    balls_.draw();
    programs_.rodDepth.use();
    rods_.draw();
    programs_.boxDepth.use();
    boxes_.draw();
}

void Renderer::Scene::drawGroundIfBelow(const FrameUniforms& uniforms, const ShaderProgram& program) const {
    if (uniforms.eye[1] > uniforms.ground[0]) {
        glBindVertexArray(noAttributes_.name());
        program.use();
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
}

void Renderer::Scene::drawWetness(const FrameUniforms& uniforms) {
    if (patches_.empty()) {
        return;
    }
    patches_.beginSolids(target_->width(), target_->height());
    frameBlock_.bind(uniforms);
    drawSolidDepths();
    drawGroundIfBelow(uniforms, programs_.groundDepth);
    patches_.drawOntoSolids();
}

void Renderer::Scene::drawScene(const FrameUniforms& uniforms) {
    target_->bind();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    frameBlock_.bind(uniforms);
    shadow_.bindForLookup();
    patches_.bindForLookup();
    programs_.sheet.use();
    for (std::size_t i = 0; i < sheetCount_; ++i) {
        sheets_[i].draw();
    }
    programs_.ball.use();
    balls_.draw();
    programs_.rod.use();
    rods_.draw();
    programs_.box.use();
    boxes_.draw();
    // What covers the most pixels comes last, where most of it is hidden already.
    drawGroundIfBelow(uniforms, programs_.ground);
    glBindVertexArray(noAttributes_.name());
    programs_.sky.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    if (!waters_.empty()) {
        target_->resolveForLookup();
        programs_.water.use();
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
    programs_.present.use();
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
    const std::vector<Ball> balls = drawableBalls(picture.balls);
    const std::vector<Rod> rods = drawableRods(picture.rods);
    const std::vector<Box> boxes = drawableBoxes(picture.boxes);
    balls_.upload(instances(balls));
    rods_.upload(instances(rods));
    boxes_.upload(instances(boxes));
    waters_.upload(instances(drawableWaters(picture.waters)));
    patches_.upload(picture.patches);
    airborne_.upload(picture);
    std::vector<Eigen::Vector3f> casters = uploadSheets(picture.sheets);
    addCorners(casters, balls);
    addCorners(casters, rods);
    addCorners(casters, boxes);
    const ShadowFit shadow = fitShadow(casters, picture.towardsSun.normalized(), shadow_.resolution());
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    const FrameUniforms uniforms = cameraUniforms(picture, balls, aspect, shadow);

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
