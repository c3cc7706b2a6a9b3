// How water comes to a body's sheet and leaves it, under the name of a source.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "body_watch.h"
#include "drench/moisture.h"
#include "drench/precision.h"
#include "drench/source.h"
#include "node_masses.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// Books in one account of the sheet's moisture, notes the momentum that arrives, and wakes the body.
class AccountSupply final : public Supply {
  public:
    /// @param momentumShare  of arriving water that pushes the body: 1 / waterSpeed for a source that runs in
    ///     water time, since the body is hit by so much less in its own time
    AccountSupply(Moisture& moisture, std::vector<Arrival>& arrivals, btSoftBody& body,
                  const BodyWatch& watch, std::size_t account, double momentumShare)
        : moisture_(moisture),
          arrivals_(arrivals),
          body_(body),
          watch_(watch),
          account_(account),
          momentumShare_(momentumShare) {}

    void addFilm(std::size_t node, double mass, const Eigen::Vector3d& velocity) override;
    void addFilm(std::size_t node, double mass) override;
    void addPores(std::size_t node, double mass) override;
    double takeFilm(std::size_t node, double mass) override;
    double takePores(std::size_t node, double mass) override;
    void cover(std::size_t node, double share) override;

  private:
    void wake(double mass);

    Moisture& moisture_;
    std::vector<Arrival>& arrivals_;
    btSoftBody& body_;
    const BodyWatch& watch_;
    std::size_t account_;
    double momentumShare_;
};

/// Takes nothing and gives nothing.
class NoSupply final : public Supply {
  public:
    void addFilm(std::size_t, double, const Eigen::Vector3d&) override {}
    void addFilm(std::size_t, double) override {}
    void addPores(std::size_t, double) override {}
    double takeFilm(std::size_t, double) override { return 0; }
    double takePores(std::size_t, double) override { return 0; }
    void cover(std::size_t, double) override {}
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
