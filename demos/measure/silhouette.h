// The silhouette of a sheet, seen vertically from above.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <Eigen/Core>
#include <vector>

#include "viewer/gl/image.h"

namespace drench::demo {

// The vertical projection of a sheet onto the ground, on a square of pixels.
class Silhouette {
  public:
    // @param centre  of the square, m (x and z)
    // @param reach   half the edge of the square, m
    Silhouette(const btSoftBody& sheet, const Eigen::Vector2d& centre, double reach, int pixels);

    double area() const;  // m2

    // Radii of the silhouette from the centre, m, in `directions` directions, the first along x.
    std::vector<double> radii(int directions) const;

    // Black on white, with circles around the centre, m.
    viewer::Image image(const std::vector<double>& circles) const;

  private:
    void cover(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);
    // In pixels from the corner of the square.
    Eigen::Vector2d projected(const btVector3& position) const;
    double pixelSize() const { return 2 * reach_ / pixels_; }

    Eigen::Vector2d centre_;
    double reach_;
    int pixels_;
    std::vector<unsigned char> covered_;
};

// Number of maxima of a closed curve that are at least `prominence` above the minima on both sides.
int countLobes(const std::vector<double>& radii, double prominence);

// Dominant number of waves of a closed curve, 1 to `max`: the order of its largest Fourier component.
int dominantOrder(const std::vector<double>& radii, int max);

}  // namespace drench::demo
