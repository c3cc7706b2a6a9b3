#include "viewer/passes/solid_pass.h"

#include "viewer/shaders/shaders.h"

namespace drench::viewer {

namespace {

ShaderProgram lit(const char* name, const char* vertex, const char* fragment) {
    return {name,
            {shaders::frame, shaders::turning, vertex},
            {shaders::frame, shaders::sky, shaders::occlusion, shaders::material, shaders::noise,
             shaders::wetting, shaders::solidMaterials, fragment}};
}

ShaderProgram shadow(const char* name, const char* vertex) {
    return {name, {shaders::frame, shaders::turning, vertex}, {shaders::solidShadowFragment}};
}

void addCorners(std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& centre, float radius) {
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3f sign((corner & 1) != 0 ? 1.0f : -1.0f, (corner & 2) != 0 ? 1.0f : -1.0f,
                                   (corner & 4) != 0 ? 1.0f : -1.0f);
        points.emplace_back(centre + radius * sign);
    }
}

void addCorners(std::vector<Eigen::Vector3f>& points, const Ball& ball) {
    addCorners(points, ball.centre, ball.radius);
}

void addCorners(std::vector<Eigen::Vector3f>& points, const Rod& rod) {
    addCorners(points, rod.from, rod.radius);
    addCorners(points, rod.to, rod.radius);
}

void addCorners(std::vector<Eigen::Vector3f>& points, const Box& box) {
    // In any orientation it lies within the sphere through its corners.
    addCorners(points, box.centre, box.halfExtents.norm());
}

template <typename Solid>
void uploadTo(Solids& buffer, const std::vector<Solid>& solids, std::vector<Eigen::Vector3f>& casters) {
    buffer.upload(solids);
    for (const Solid& solid : solids) addCorners(casters, solid);
}

}  // namespace

SolidPass::SolidPass()
    : programs_{lit("ball", shaders::ballVertex, shaders::ballFragment),
                lit("rod", shaders::rodVertex, shaders::rodFragment),
                lit("box", shaders::boxVertex, shaders::boxFragment)},
      shadowPrograms_{shadow("ball shadow", shaders::ballVertex), shadow("rod shadow", shaders::rodVertex),
                      shadow("box shadow", shaders::boxVertex)} {}

void SolidPass::upload(const Picture& picture, std::vector<Eigen::Vector3f>& casters) {
    uploadTo(balls_, drawable(picture.balls), casters);
    uploadTo(rods_, drawable(picture.rods), casters);
    uploadTo(boxes_, drawable(picture.boxes), casters);
}

void SolidPass::drawShadows() const {
    draw(shadowPrograms_);
}

void SolidPass::draw() const {
    draw(programs_);
}

void SolidPass::draw(const Programs& programs) const {
    programs.ball.use();
    balls_.draw();
    programs.rod.use();
    rods_.draw();
    programs.box.use();
    boxes_.draw();
}

}  // namespace drench::viewer
