// What a sheet covers, seen from straight above.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <Eigen/Core>
#include <vector>

#include "viewer/gl/image.h"

namespace drench::demo {

// The shadow of a sheet on level ground, on a square of pixels.
class Silhouette {
  public:
    // @param centre  of the square, m (x and z)
    // @param reach   half the square's side, m
    Silhouette(const btSoftBody& sheet, const Eigen::Vector2d& centre, double reach, int pixels);

    double area() const;  // m2

    // How far the shadow reaches from the centre, m, in so many directions, the first along x.
    std::vector<double> radii(int directions) const;

    // Black on white, with circles around the centre, m.
    viewer::Image image(const std::vector<double>& circles) const;

  private:
    void cover(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);
    // In pixels from the square's corner.
    Eigen::Vector2d projected(const btVector3& position) const;
    double pixelSize() const { return 2 * reach_ / pixels_; }

    Eigen::Vector2d centre_;
    double reach_;
    int pixels_;
    std::vector<unsigned char> covered_;
};

// Number of maxima of a closed curve that stand at least so far above the minima on both sides.
int countLobes(const std::vector<double>& radii, double prominence);

// How many waves a closed curve has mostly, 1 to `most`: the order of its largest Fourier component.
int dominantOrder(const std::vector<double>& radii, int max);

}  // namespace drench::demo
