#include "account_supply.h"

#include <stdexcept>
#include <string>

#include "vectors.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

void AccountSupply::addFilm(std::size_t node, double mass, const Eigen::Vector3d& velocity) {
    constexpr double fastest = 1e6;  // m/s, whose momentum a float can hold
    if (!(velocity.cwiseAbs().maxCoeff() <= fastest) || !velocity.allFinite())
        throw std::invalid_argument("drench: water for node " + std::to_string(node) +
                                    " arrives with a velocity that is not finite or over 1e6; give m/s");
    moisture_.addFilm(node, mass, account_);
    Arrival& arrival = arrivals_[node];
    arrival.carried += mass * (1 - momentumShare_);
    arrival.mass += mass * momentumShare_;
    arrival.momentum += toBullet(velocity * mass * momentumShare_);
    wake(mass);
}

void AccountSupply::addFilm(std::size_t node, double mass) {
    moisture_.addFilm(node, mass, account_);
    arrivals_[node].carried += mass;
    wake(mass);
}

void AccountSupply::addPores(std::size_t node, double mass) {
    moisture_.addPores(node, mass, account_);
    arrivals_[node].carried += mass;
    wake(mass);
}

double AccountSupply::takeFilm(std::size_t node, double mass) {
    const double taken = moisture_.takeFilm(node, mass, account_);
    wake(taken);
    return taken;
}

double AccountSupply::takePores(std::size_t node, double mass) {
    const double taken = moisture_.takePores(node, mass, account_);
    wake(taken);
    return taken;
}

void AccountSupply::cover(std::size_t node, double share) {
    moisture_.cover(node, share);
}

void AccountSupply::wake(double mass) {
    if (mass > 0 && watch_.bodyIsAlive()) body_.activate();
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
