// A sheet hangs half under a roof while it rains.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "../timed_scene.h"
#include "../water_effects.h"

namespace drench::demo {

/// A sheet, 1.2 m square, hangs level between four posts, held at its corners and at the middle of two sides,
/// and sags like an awning. A roof covers the half of it at x < 0. First it comes to rest, then rain falls
/// for the rest of the time. The air is sealed off, so that all water in the sheltered half came out of the
/// rain.
class HalfUnderRoof final : public TimedScene {
  public:
    explicit HalfUnderRoof(const SceneOptions& options);
    ~HalfUnderRoof() override;

    void advance() override;
    std::string status() const override;
    viewer::Picture picture() const override;
    std::optional<std::string> moment() const override;
    std::vector<SceneSheet> sheets() override { return {{"awning", cloth_.get()}}; }
    std::vector<Column> columns() const override;
    std::vector<double> row() const override;
    void report(std::ostream& out) const override;
    std::vector<std::string> failures() const override;

  private:
    void hang(const btVector3& position, int node);
    void addSheet(const SceneOptions& options);
    double openGround() const;
    double rainTime() const;
    double saturationBetween(double from, double to) const;
    double shareDeepInShelter() const;
    double sag() const;
    double brought() const { return broughtBy(*rain_, *cloth_); }  // kg
    std::vector<double> reportRow() const;
    void showPosts(viewer::Picture& picture) const;

    int nodes_;  // along each side
    btRigidBody* roof_ = nullptr;
    std::unique_ptr<btSoftBody> sheet_;
    std::unique_ptr<WetCloth> cloth_;
    Rain* rain_ = nullptr;
    std::unique_ptr<FallingDrops> drops_;
    std::unique_ptr<WaterEffects> effects_;
    double openAreaTime_ = 0;  // m2 s of open ground since the rain began
    Table table_;              // every five seconds, for the report
};

}  // namespace drench::demo
