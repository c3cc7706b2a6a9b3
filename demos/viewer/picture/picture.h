// What a picture shows, as plain data. Lengths are metres, angles are radians, y is up, colours are linear
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

// How the threads of a cloth run.
enum class Weave { plain, twill, knit };

// A two-sided cloth surface; the renderer computes its normals. A sheet without triangles, or with a position
// that is not finite or lies more than 100 km out, is left out of the picture.
struct SheetMesh {
    // Where each node is.
    std::vector<Eigen::Vector3f> positions;
    // The diffuse colour of each node; as many as positions.
    std::vector<Eigen::Vector3f> albedo;
    // How much of each node a film of water covers, 0 (matt) to 1 (glossy); as many as positions.
    std::vector<float> gloss;
    // Three node indices each, wound alike over the whole sheet.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    // How full of water the pores of each node are, 0 to 1; as many as positions, or empty for dry cloth.
    std::vector<float> dampness;
    // Share of the light that passes through each node, 0 to 1; as many as positions, or empty for none.
    std::vector<float> transmittance;
    // Where each node lies in the flat cloth, metres, for its threads; as many as positions, or empty for
    // none.
    std::vector<Eigen::Vector2f> clothCoordinates;
    Weave weave = Weave::plain;
    // From one thread to the next, above 0.
    float threadSpacing = 0.5e-3f;
    // What each node has of the quantity of the picture's legend; as many as positions, or empty for none.
    std::vector<float> values;
};

// What a solid is made of. Its colour is the albedo of the solid; grain, sheen and unevenness come from this.
enum class Material { paint, wood, metal, stone, rope };

// A striped ball.
struct Ball {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    // Above 0; a ball of radius 0 or less is left out.
    float radius = 0.1f;
    // Turns the stripes; has unit length.
    Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
    // Colour of the dark stripes; the light ones are a paler tone of it.
    Eigen::Vector3f albedo = Eigen::Vector3f(0.65f, 0.16f, 0.08f);
    // Only paint has stripes.
    Material material = Material::paint;
};

// A rod with round ends: a piece of clothes line, a post or a pin.
struct Rod {
    Eigen::Vector3f from = Eigen::Vector3f::Zero();
    Eigen::Vector3f to = Eigen::Vector3f::UnitY();
    // Above 0; the round ends reach this far beyond `from` and `to`.
    float radius = 0.01f;
    Eigen::Vector3f albedo = Eigen::Vector3f(0.4f, 0.4f, 0.4f);
    // The grain of wood and the strands of a rope run along it.
    Material material = Material::wood;
};

// A box with flat faces: a table top, a roof.
struct Box {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    // Half its length along each of its own axes, above 0; a box without volume is left out.
    Eigen::Vector3f halfExtents = Eigen::Vector3f::Constant(0.1f);
    // Turns its axes; has unit length.
    Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
    Eigen::Vector3f albedo = Eigen::Vector3f(0.4f, 0.4f, 0.4f);
    // The grain of wood runs along the longest side, in boards where the box is wide.
    Material material = Material::stone;
};

// Standing water: a box along the axes of the world, as in a tank of clear glass, with a rippled level
// surface. What is in it is seen through it; it casts no shadow. One water is not seen through another.
struct Water {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    // Half its length along each axis, above 0; water without volume is left out.
    Eigen::Vector3f halfExtents = Eigen::Vector3f::Constant(0.1f);
    // Of its ripples, seconds.
    float time = 0.0f;
};

// A drop in flight: a clear ball, drawn out along its way by the time that the picture is exposed.
struct WaterDrop {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    // Metres a second.
    Eigen::Vector3f velocity = Eigen::Vector3f::Zero();
    // Above 0.
    float radius = 0.002f;
};

// Something too quick or too small to be seen by itself, such as a drop of rain: a faint line.
struct Streak {
    Eigen::Vector3f from = Eigen::Vector3f::Zero();
    Eigen::Vector3f to = Eigen::Vector3f::Zero();
    // Across, metres, above 0.
    float width = 0.001f;
    // 0 (not there) to 1.
    float opacity = 0.3f;
};

// A cloud of droplets, densest in its middle.
struct MistPuff {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    // Above 0.
    float radius = 0.05f;
    // Share of the light that its middle takes, 0 to 1.
    float density = 0.1f;
};

// A wet spot on the ground or on a ball, rod or box: what lies within the radius is wet, with an uneven
// edge.
struct WetPatch {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    // Above 0.
    float radius = 0.01f;
    // 0 (dry) to 1 (dark and glossy).
    float wetness = 1.0f;
    // Turns the outline with the body that the patch is on; has unit length.
    Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
    // Picks one of many outlines, 0 to 1; the same number gives the same one.
    float outline = 0.0f;
};

// What rain has done to the ground out in the open, beyond a rectangle within which patches tell. It blends into
// them over half a metre within the border.
struct OpenGround {
    // Share of it that drops have met, 0 to 1.
    float covered = 0.0f;
    // Of what they have met, 0 (dry) to 1 (dark and glossy).
    float wetness = 1.0f;
    // Corners of the rectangle, x and z.
    Eigen::Vector2f from = Eigen::Vector2f::Zero();
    Eigen::Vector2f to = Eigen::Vector2f::Zero();
};

// What the colours of a picture of a quantity mean; they run evenly from one value to the other.
struct Legend {
    // With its unit: "water content, kg/kg".
    std::string title;
    float from = 0.0f;
    // Above `from`.
    float to = 1.0f;
};

// A perspective camera that circles round the point it looks at.
struct Camera {
    // The point in the middle of the picture.
    Eigen::Vector3f target = Eigen::Vector3f(0.0f, 1.2f, 0.0f);
    // From the eye to the target, above 0.
    float distance = 5.0f;
    // 0 looks along -z (the eye is on the +z side); growing yaw carries the eye towards +x.
    float yaw = 0.0f;
    // 0 looks level, growing pitch raises the eye; stays short of a quarter turn either way.
    float pitch = 0.15f;
    // Full angle between the lower and the upper edge of the picture, between 0 and pi.
    float verticalFieldOfView = 0.75f;

    // Where the eye is.
    Eigen::Vector3f eye() const;
    // Unit vector from the eye towards the target.
    Eigen::Vector3f forward() const;
    // Unit vector to the right of the picture.
    Eigen::Vector3f right() const;
    // World to eye space (x right, y up, looking along -z), 4 x 4.
    Eigen::Matrix4f view() const;
    // Eye space to OpenGL clip space for a picture `aspect` times as wide as high, 4 x 4.
    Eigen::Matrix4f projection(float aspect) const;
    // Distance of the near plane; nothing closer is drawn.
    float nearPlane() const;
    // Distance of the far plane.
    float farPlane() const;
    // Throws std::runtime_error, naming the field, unless every field is finite and in its range.
    void check() const;
};

// Everything one frame shows.
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
    // Height of the level ground, a terrace of flagstones (10 rows of 0.5 m, 0.7 m long each) in a lawn; it
    // is seen from above only.
    float groundHeight = 0.0f;
    // Points from the scene to the sun; any length above 0.
    Eigen::Vector3f towardsSun = Eigen::Vector3f(-0.62f, 0.75f, 0.50f);
    // Share of its light that passes the clouds, 0 (overcast, with a paler sky) to 1.
    float sunshine = 1.0f;
    Camera camera;
    // Shows the values of the sheets in colours in place of their own looks.
    std::optional<Legend> legend;
    // Lines of UTF-8 text, written from the top left corner downwards; long lines are wrapped.
    std::vector<std::string> caption;
    // The same along the lower edge.
    bool captionBelow = false;
};

}  // namespace drench::viewer
