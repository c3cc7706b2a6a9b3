// How water comes to a body's sheet and leaves it, under the name of a source.
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

// Books in one account of the sheet's moisture, notes the momentum that arrives, and wakes the body.
class AccountSupply final : public Supply {
  public:
    // What it works on, all of which outlives it.
    struct Sheet {
        Moisture& moisture;
        std::vector<Arrival>& arrivals;
        Submersion& submersion;
        btSoftBody& body;
        const BodyWatch& watch;
    };
    // @param momentumFraction  of arriving water that pushes the body: 1 / waterSpeed for a source that runs in
    //     water time, since the body is hit by so much less in its own time
    // @param noticeable     water beyond which the body wakes, kg; what comes flying always wakes it
    AccountSupply(const Sheet& sheet, std::size_t account, double momentumFraction, double noticeable)
        : sheet_(sheet), account_(account), momentumFraction_(momentumFraction), noticeable_(noticeable) {}

    // As in the constructor, from now on.
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
    double unnoticed_ = 0;  // water that has come and gone since it last woke the body, kg
};

// Takes nothing and gives nothing.
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
