// One sheet in each kind of world that Drench serves.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "bullet/bullet_solvers/deformable_rig.h"
#include "worlds.h"

namespace drench::test {

// What moves the sheet.
enum class Mover { smallSteps, stock, deformable };

inline const char* nameOf(Mover mover) {
    return mover == Mover::smallSteps ? "small steps" : mover == Mover::stock ? "stock" : "deformable";
}

constexpr Mover movers[] = {Mover::smallSteps, Mover::stock, Mover::deformable};

// A sheet of 9 x 9 nodes, half a metre square, hung from its upper edge, and its WetCloth.
class AnyWorld {
  public:
    explicit AnyWorld(Mover mover, const SheetSettings& settings = {}, int nodesASide = 9,
                      const Fabric& fabric = fabrics::cottonPlain())
        : mover_(mover) {
        if (mover == Mover::deformable)
            deformable_ = std::make_unique<DeformableWorld>(Mode::implicitSteps);
        else
            bullet_ = std::make_unique<demo::BulletWorld>(mover == Mover::smallSteps ? &solver_ : nullptr);
        sheet_ = hangingSheet(info(), fabric, 0.5, nodesASide);
        if (deformable_)
            deformable_->add(*sheet_);
        else
            bullet_->world().addSoftBody(sheet_.get());
        cloth_ = std::make_unique<WetCloth>(world(), *sheet_, fabric, settings);
    }
    ~AnyWorld() {
        cloth_.reset();
        if (sheet_) world().removeCollisionObject(sheet_.get());
    }
    AnyWorld(const AnyWorld&) = delete;
    AnyWorld& operator=(const AnyWorld&) = delete;

    btDiscreteDynamicsWorld& world() {
        if (deformable_) return deformable_->world();
        return bullet_->world();
    }
    btSoftBodyWorldInfo& info() { return deformable_ ? deformable_->info() : bullet_->worldInfo(); }
    btSoftBody& sheet() { return *sheet_; }
    WetCloth& cloth() { return *cloth_; }
    std::unique_ptr<WetCloth>& clothOwner() { return cloth_; }

    double substep() const { return mover_ == Mover::smallSteps ? 1.0 / 60 : 1.0 / 240; }
    // Runs for so many substeps of the length that suits the mover.
    void run(int substeps) {
        constexpr int variableStep = 0;
        for (int i = 0; i < substeps; ++i) world().stepSimulation(btScalar(substep()), variableStep);
    }

  private:
    Mover mover_;
    SmallStepSolver solver_;
    std::unique_ptr<DeformableWorld> deformable_;
    std::unique_ptr<demo::BulletWorld> bullet_;
    std::unique_ptr<btSoftBody> sheet_;
    std::unique_ptr<WetCloth> cloth_;
};

// How far the ledger is from closing, over what was supplied, 1.
inline double ledgerError(const WetCloth& cloth) {
    const Ledger ledger = cloth.ledger();
    const double out = ledger.held + ledger.dripped + ledger.evaporated + ledger.returned;
    return std::abs(ledger.supplied - out) / std::max(ledger.supplied, 1e-9);
}

// The report of a kind of trouble; fails the test if there is none.
inline TroubleReport reportOf(const WetCloth& cloth, Trouble what) {
    for (const TroubleReport& report : cloth.troubles())
        if (report.what == what) return report;
    ADD_FAILURE() << "no such trouble among " << cloth.troubles().size();
    return {};
}

}  // namespace drench::test
