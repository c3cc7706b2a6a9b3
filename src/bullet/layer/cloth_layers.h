// Layers of cloth that touch a sheet: what they cover, how they press it, and the water that passes.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <Eigen/Core>
#include <vector>

#include "bullet/fluid/rigid_shelter.h"
#include "bullet/sheet/sheet_mechanics.h"
#include "drench/config.h"
#include "drench/moisture.h"
#include "drench/source.h"
#include "water/layer_contacts.h"
#include "water/layer_wicking.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

class BulletPass;

class ClothLayers {
  public:
    // @param lightPressure  that squeezes hardly anything out, Pa
    ClothLayers(const Fabric& fabric, std::size_t nodes, double lightPressure);

    // Reads the contacts of the last substep. @param bodyStep  of the body's time since then, s
    // @param areas  of the nodes, m2
    void read(const LayerTouches& touches, const std::vector<double>& areas, double bodyStep);
    // Fraction of a node that cloth covers on the side that faces a direction.
    double covered(std::size_t node, const Eigen::Vector3d& towards, double area) const;

    // Mean pressure on a node in the last time, Pa; 0 where it is too small to matter.
    double pressure(std::size_t node) const;

    // A layer, and the direction upwards, which is zero without gravity.
    struct Sheet {
        Moisture& moisture;
        const std::vector<double>& areas;  // of the nodes, m2
        const Eigen::Vector3d& up;
        double gravity;  // m/s2
    };
    // For the next step of its water.
    void cover(const Sheet& sheet) const;
    void press(const Sheet& sheet) const;
    void join(const Sheet& sheet, const LayerTouches& touches);

    // Passes water to another sheet and back. Film is passed by the sheet on which it is, pore water by one of both.
    struct Partner {
        int number;  // in the contacts of the sheet
        TouchableWater& water;
        const std::vector<double>& areas;
        bool movesPores;  // whether it is this sheet that moves them
    };
    void exchange(const Sheet& sheet, Supply& supply, const LayerTouches& touches, const Partner& partner,
                  double waterTime);

    bool isPressed() const { return isPressed_; }
    void state(BulletPass& pass);

  private:
    void average(const std::vector<double>& areas, double bodyStep);
    bool isWet(const Moisture& moisture, const std::vector<LayerPair>& pairs, bool isOther) const;
    void movePores(const Sheet& sheet, Supply& supply, const Partner& partner,
                   const std::vector<LayerPair>& pairs, double waterTime);
    void moveFilm(const Sheet& sheet, Supply& supply, const Partner& partner,
                  const std::vector<LayerPair>& pairs, double waterTime);

    Fabric fabric_;
    ContactSides sides_;
    LayerContacts contacts_;
    LayerFilm film_;
    double leastPressure_;  // that matters, Pa
    bool isPressed_ = false;
    std::vector<float> pressures_;                            // mean of the last time, of each node, Pa
    std::vector<double> poresHere_, poresThere_, roomThere_;  // kg
};

// Shelter by solids, and by layers of cloth on the sheet.
class SheetShelter final : public Shelter {
  public:
    SheetShelter(const RigidShelter& solids, const ClothLayers& layers, const std::vector<double>& areas)
        : solids_(solids), layers_(layers), areas_(areas) {}
    bool blocked(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const override {
        return solids_.blocked(from, to);
    }
    double covered(std::size_t node, const Eigen::Vector3d& towards) const override {
        return layers_.covered(node, towards, areas_[node]);
    }

  private:
    const RigidShelter& solids_;
    const ClothLayers& layers_;
    const std::vector<double>& areas_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
