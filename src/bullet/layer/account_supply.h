// Adds water to a sheet and takes water from it, in the ledger account of a source.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/fluid/submersion.h"
#include "bullet/sheet/node_masses.h"
#include "bullet/world/body_watch.h"
#include "drench/config.h"
#include "drench/moisture.h"
#include "drench/source.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

class BulletPass;

// Records water in one account of the sheet's moisture, collects the momentum that arrives, and wakes the
// body.
class AccountSupply final : public Supply {
  public:
    // The objects that it changes; all must outlive it.
    struct Sheet {
        Moisture& moisture;
        std::vector<Arrival>& arrivals;
        Submersion& submersion;
        btSoftBody& body;
        const BodyWatch& watch;
    };
    // @param momentumFraction  fraction of the momentum of arriving water that acts on the body: 1 /
    //     waterSpeed for a source that runs in water time
    // @param noticeable     mass of water above which the body wakes, kg; water with a velocity always wakes
    //     it
    AccountSupply(const Sheet& sheet, std::size_t account, double momentumFraction, double noticeable)
        : sheet_(sheet), account_(account), momentumFraction_(momentumFraction), noticeable_(noticeable) {}

    // Changes these parameters of the constructor.
    void setMomentumFraction(double momentumFraction) { momentumFraction_ = momentumFraction; }

    void addFilm(std::size_t node, double mass, const Eigen::Vector3d& velocity) override;
    void addFilm(std::size_t node, double mass) override;
    void addPores(std::size_t node, double mass) override;
    double takeFilm(std::size_t node, double mass) override;
    double takePores(std::size_t node, double mass) override;
    void cover(std::size_t node, double fraction) override;
    void submerge(std::size_t node, double depth, const Eigen::Vector3d& velocity) override;

  private:
    friend class BulletPass;
    void state(BulletPass& pass);

    void count(double mass);
    void wake();

    Sheet sheet_;
    std::size_t account_;
    double momentumFraction_;
    double noticeable_;     // kg
    double unnoticed_ = 0;  // added and taken since it last woke the body, kg
};

// Adds and takes no water.
class NoSupply final : public Supply {
  public:
    void addFilm(std::size_t, double, const Eigen::Vector3d&) override {}
    void addFilm(std::size_t, double) override {}
    void addPores(std::size_t, double) override {}
    double takeFilm(std::size_t, double) override { return 0; }
    double takePores(std::size_t, double) override { return 0; }
    void cover(std::size_t, double) override {}
    void submerge(std::size_t, double, const Eigen::Vector3d&) override {}
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
