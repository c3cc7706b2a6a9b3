// Contents of a picture, as plain data. Lengths are in metres, angles in radians, y is up, colours are linear
// RGB from 0 to 1.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace drench::viewer {

// Construction of a cloth, for its pattern of threads.
enum class Weave { plain, twill, knit };

// A two-sided cloth surface; the renderer computes its normals. A sheet without triangles, or with a position
// that is not finite or more than 100 km away, is not drawn.
struct SheetMesh {
    // Position of each node.
    std::vector<Eigen::Vector3f> positions;
    // The diffuse colour of each node; as many as positions.
    std::vector<Eigen::Vector3f> albedo;
    // Gloss of each node by its water film, 0 (matt) to 1 (glossy); as many as positions.
    std::vector<float> gloss;
    // Node indices of each triangle, with the same orientation throughout the sheet.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    // Pore saturation of each node, 0 to 1; as many as positions, or empty for dry cloth.
    std::vector<float> dampness;
    // Transmittance of each node, 0 to 1; as many as positions, or empty for none.
    std::vector<float> transmittance;
    // Material coordinates of each node, m, for its threads; as many as positions, or empty for none.
    std::vector<Eigen::Vector2f> clothCoordinates;
    Weave weave = Weave::plain;
    // Thread spacing, m, above 0.
    float threadSpacing = 0.5e-3f;
    // Value of each node of the quantity of the picture's legend; as many as positions, or empty for none.
    std::vector<float> values;
};

// Material of a solid. The colour of the solid is its albedo; grain, gloss and unevenness come from the
// material.
enum class Material { paint, wood, metal, stone, rope };

// A striped ball.
struct Ball {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    // Above 0; a ball with a radius of 0 or less is not drawn.
    float radius = 0.1f;
    // Rotation of the stripes; unit quaternion.
    Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
    // Colour of the dark stripes; the light ones are a lighter tone of it.
    Eigen::Vector3f albedo = Eigen::Vector3f(0.65f, 0.16f, 0.08f);
    // Only paint has stripes.
    Material material = Material::paint;
};

// A capsule: a piece of clothes line, a post or a pin.
struct Rod {
    Eigen::Vector3f from = Eigen::Vector3f::Zero();
    Eigen::Vector3f to = Eigen::Vector3f::UnitY();
    // Above 0; the round ends reach this far beyond `from` and `to`.
    float radius = 0.01f;
    Eigen::Vector3f albedo = Eigen::Vector3f(0.4f, 0.4f, 0.4f);
    // The grain of wood and the strands of a rope run along its axis.
    Material material = Material::wood;
};

// A box with flat faces: a table top, a roof.
struct Box {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    // Half its edge lengths, above 0; a box without volume is not drawn.
    Eigen::Vector3f halfExtents = Eigen::Vector3f::Constant(0.1f);
    // Rotation of its axes; unit quaternion.
    Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
    Eigen::Vector3f albedo = Eigen::Vector3f(0.4f, 0.4f, 0.4f);
    // The grain of wood runs along the longest edge, in boards if the box is wide.
    Material material = Material::stone;
};

// A pool: an axis-aligned box of water, as in a transparent tank, with a rippled level surface. Objects in it
// are visible through it; it casts no shadow. A pool is not visible through another pool.
struct Water {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    // Half its edge lengths, above 0; a pool without volume is not drawn.
    Eigen::Vector3f halfExtents = Eigen::Vector3f::Constant(0.1f);
    // Time for its ripples, s.
    float time = 0.0f;
};

// A drop in flight: a transparent ball, with motion blur along its path.
struct WaterDrop {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    // m/s.
    Eigen::Vector3f velocity = Eigen::Vector3f::Zero();
    // Above 0.
    float radius = 0.002f;
};

// A faint line, for an object too fast or too small to be visible, such as a drop of rain.
struct Streak {
    Eigen::Vector3f from = Eigen::Vector3f::Zero();
    Eigen::Vector3f to = Eigen::Vector3f::Zero();
    // Width, m, above 0.
    float width = 0.001f;
    // Opacity, 0 (invisible) to 1.
    float opacity = 0.3f;
};

// A cloud of droplets, densest at its centre.
struct MistPuff {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    // Above 0.
    float radius = 0.05f;
    // Fraction of the light that its centre absorbs, 0 to 1.
    float density = 0.1f;
};

// A wet spot on the ground or on a ball, capsule or box: the area within the radius is wet, with an uneven
// edge.
struct WetPatch {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    // Above 0.
    float radius = 0.01f;
    // 0 (dry) to 1 (dark and glossy).
    float wetness = 1.0f;
    // Rotates the outline with the body of the patch; unit quaternion.
    Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
    // Selects one of many outlines, 0 to 1; the same number gives the same outline.
    float outline = 0.0f;
};

// Wetness of the ground by rain outside a rectangle; inside it there are patches. Both are blended over half
// a metre inside the border.
struct OpenGround {
    // Fraction that drops have hit, 0 to 1.
    float covered = 0.0f;
    // Wetness of that fraction, 0 (dry) to 1 (dark and glossy).
    float wetness = 1.0f;
    // Corners of the rectangle, x and z.
    Eigen::Vector2f from = Eigen::Vector2f::Zero();
    Eigen::Vector2f to = Eigen::Vector2f::Zero();
};

// The range of values for the colours of a picture, which are uniform in between.
struct Legend {
    // Including the unit: "water content, kg/kg".
    std::string title;
    float from = 0.0f;
    // Above `from`.
    float to = 1.0f;
};

// A perspective camera that orbits around its target.
struct Camera {
    // The point in the centre of the picture.
    Eigen::Vector3f target = Eigen::Vector3f(0.0f, 1.2f, 0.0f);
    // Distance from the camera to the target, m, above 0.
    float distance = 5.0f;
    // 0 looks along -z (the camera is on the +z side); positive yaw moves the camera towards +x.
    float yaw = 0.0f;
    // 0 looks horizontally, positive pitch raises the camera; less than a quarter turn either way.
    float pitch = 0.15f;
    // Full vertical angle of view, between 0 and pi.
    float verticalFieldOfView = 0.75f;

    // Position of the camera.
    Eigen::Vector3f eye() const;
    // Unit vector from the camera towards the target.
    Eigen::Vector3f forward() const;
    // Unit vector to the right of the picture.
    Eigen::Vector3f right() const;
    // World to camera space (x right, y up, looking along -z), 4 x 4.
    Eigen::Matrix4f view() const;
    // Camera space to OpenGL clip space for a picture `aspect` times as wide as high, 4 x 4.
    Eigen::Matrix4f projection(float aspect) const;
    // Distance of the near plane; closer objects are not drawn.
    float nearPlane() const;
    // Distance of the far plane.
    float farPlane() const;
    // Throws std::runtime_error that names the field, unless every field is finite and in its range.
    void check() const;
};

// Everything that a frame shows.
struct Picture {
    std::vector<SheetMesh> sheets;
    std::vector<Ball> balls;
    std::vector<Rod> rods;
    std::vector<Box> boxes;
    std::vector<Water> waters;
    std::vector<WaterDrop> drops;
    std::vector<Streak> streaks;
    std::vector<MistPuff> mist;
    std::vector<WetPatch> patches;
    OpenGround openGround;
    // Height of the horizontal ground, a terrace of flagstones (10 rows of 0.5 m, 0.7 m long each) in a lawn;
    // it is visible from above only.
    float groundHeight = 0.0f;
    // Direction from the scene to the sun; any length above 0.
    Eigen::Vector3f towardsSun = Eigen::Vector3f(-0.62f, 0.75f, 0.50f);
    // Fraction of the sunlight that passes the clouds, 0 (overcast, with a paler sky) to 1.
    float sunshine = 1.0f;
    Camera camera;
    // If present, the values of the sheets are shown as colours in place of their appearance.
    std::optional<Legend> legend;
    // Lines of UTF-8 text at the top left; long lines are wrapped.
    std::vector<std::string> caption;
    // The same at the bottom left.
    bool captionBelow = false;
};

}  // namespace drench::viewer
