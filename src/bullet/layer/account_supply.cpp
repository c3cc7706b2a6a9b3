#include "bullet/layer/account_supply.h"

#include <cmath>
#include <stdexcept>

#include "bullet/world/vectors.h"
#include "checks/checks.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// Largest velocity whose momentum a float can represent.
void checkVelocity(const char* what, std::size_t node, const Eigen::Vector3d& velocity) {
    constexpr double fastest = 1e6;  // m/s
    if (!(velocity.cwiseAbs().maxCoeff() <= fastest) || !velocity.allFinite())
        refuse("water ", what, " node ", node, " has a velocity of ", velocity,
               " m/s; give finite numbers from -1e6 to 1e6");
}

}  // namespace

void AccountSupply::addFilm(std::size_t node, double mass, const Eigen::Vector3d& velocity) {
    checkVelocity("for", node, velocity);
    sheet_.moisture.addFilm(node, mass, account_);
    Arrival& arrival = sheet_.arrivals[node];
    arrival.carried += mass * (1 - momentumFraction_);
    arrival.mass += mass * momentumFraction_;
    arrival.momentum += toBullet(velocity * mass * momentumFraction_);
    if (mass > 0 && !velocity.isZero()) wake();
    count(mass);
}

void AccountSupply::addFilm(std::size_t node, double mass) {
    sheet_.moisture.addFilm(node, mass, account_);
    sheet_.arrivals[node].carried += mass;
    count(mass);
}

void AccountSupply::addPores(std::size_t node, double mass) {
    sheet_.moisture.addPores(node, mass, account_);
    sheet_.arrivals[node].carried += mass;
    count(mass);
}

double AccountSupply::takeFilm(std::size_t node, double mass) {
    const double taken = sheet_.moisture.takeFilm(node, mass, account_);
    count(taken);
    return taken;
}

double AccountSupply::takePores(std::size_t node, double mass) {
    const double taken = sheet_.moisture.takePores(node, mass, account_);
    count(taken);
    return taken;
}

void AccountSupply::cover(std::size_t node, double fraction) {
    sheet_.moisture.cover(node, fraction);
}

void AccountSupply::submerge(std::size_t node, double depth, const Eigen::Vector3d& velocity) {
    if (node >= sheet_.moisture.size())
        refuse<std::out_of_range>("node ", node, " of a sheet with ", sheet_.moisture.size(),
                                  " nodes; give 0 to ", sheet_.moisture.size() - 1);
    if (!(std::abs(depth) <= 1e9)) refuse("node ", node, " is ", depth, " m under water; give -1e9 to 1e9");
    checkVelocity("around", node, velocity);
    sheet_.submersion.submerge(node, depth, velocity);
}

void AccountSupply::count(double mass) {
    unnoticed_ += mass;
    if (unnoticed_ > noticeable_) wake();
}

void AccountSupply::wake() {
    unnoticed_ = 0;
    if (sheet_.watch.bodyIsAlive()) sheet_.body.activate();
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
