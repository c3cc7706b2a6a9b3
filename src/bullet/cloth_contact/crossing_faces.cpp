#include "bullet/cloth_contact/crossing_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace drench {

namespace {

using Point = Eigen::Vector2d;

// A sum of numbers without rounding (Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
// predicates", 1997: grow-expansion).
class ExactSum {
  public:
    void add(double number) {
        double sum = number;
        for (int i = 0; i < count_; ++i) {
            const double part = parts_[static_cast<std::size_t>(i)], all = sum + part, ofPart = all - sum;
            parts_[static_cast<std::size_t>(i)] = (sum - (all - ofPart)) + (part - ofPart);
            sum = all;
        }
        parts_[static_cast<std::size_t>(count_++)] = sum;
    }
    void addProduct(double a, double b, double c) {
        const double product = a * b, rest = std::fma(a, b, -product);
        for (const double of : {product, rest}) {
            add(of * c);
            add(std::fma(of, c, -(of * c)));
        }
    }
    // A number of the same sign.
    double sign() const {
        for (int i = count_; i-- > 0;)
            if (parts_[static_cast<std::size_t>(i)] != 0) return parts_[static_cast<std::size_t>(i)];
        return 0;
    }

  private:
    std::array<double, 24> parts_;  // of six products
    int count_ = 0;
};

// Six times the volume of a tetrahedron; positive if the last corner lies where the normal of the first three points to.
// The sign is exact where differences of coordinates are.
double volume(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
              const Eigen::Vector3d& d) {
    const Eigen::Vector3d u = b - a, v = c - a, w = d - a;
    const double found = u.cross(v).dot(w);
    const Eigen::Vector3d all = u.cwiseAbs(), ofV = v.cwiseAbs(), ofW = w.cwiseAbs();
    const double largest = (all.y() * ofV.z() + all.z() * ofV.y()) * ofW.x() +
                           (all.z() * ofV.x() + all.x() * ofV.z()) * ofW.y() +
                           (all.x() * ofV.y() + all.y() * ofV.x()) * ofW.z();
    constexpr double rounding = 1e-15;
    if (std::abs(found) > rounding * largest || !(largest < std::numeric_limits<double>::max())) return found;
    ExactSum sum;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        sum.addProduct(u[i], v[j], w[k]);
        sum.addProduct(-u[i], v[k], w[j]);
    }
    return sum.sign();
}

double volume(const FaceCorners& face, const Eigen::Vector3d& point) {
    return volume(face[0], face[1], face[2], point);
}

// Twice the area of a triangle in a plane.
double area(const Point& a, const Point& b, const Point& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool haveOneSign(double a, double b, double c) {
    return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

bool areOnOneSide(const std::array<double, 3>& volumes) {
    return (volumes[0] > 0 && volumes[1] > 0 && volumes[2] > 0) ||
           (volumes[0] < 0 && volumes[1] < 0 && volumes[2] < 0);
}

using FlatCorners = std::array<Point, 3>;

bool holds(const FlatCorners& face, const Point& point) {
    return haveOneSign(area(face[0], face[1], point), area(face[1], face[2], point),
                       area(face[2], face[0], point));
}

bool isBetween(const Point& a, const Point& b, const Point& point) {
    return (point.array() >= a.array().min(b.array()) && point.array() <= a.array().max(b.array())).all();
}

bool edgesMeet(const Point& a, const Point& b, const Point& c, const Point& d) {
    const double ofC = area(a, b, c), ofD = area(a, b, d), ofA = area(c, d, a), ofB = area(c, d, b);
    if (((ofC > 0 && ofD < 0) || (ofC < 0 && ofD > 0)) && ((ofA > 0 && ofB < 0) || (ofA < 0 && ofB > 0)))
        return true;
    return (ofC == 0 && isBetween(a, b, c)) || (ofD == 0 && isBetween(a, b, d)) ||
           (ofA == 0 && isBetween(c, d, a)) || (ofB == 0 && isBetween(c, d, b));
}

// An edge that lies in the plane of a face.
bool meetsInPlane(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const FaceCorners& face) {
    int leftOut = 0;
    (face[1] - face[0]).cross(face[2] - face[0]).cwiseAbs().maxCoeff(&leftOut);
    const auto flat = [leftOut](const Eigen::Vector3d& point) {
        return Point(point[(leftOut + 1) % 3], point[(leftOut + 2) % 3]);
    };
    const FlatCorners corners = {flat(face[0]), flat(face[1]), flat(face[2])};
    const Point a = flat(from), b = flat(to);
    if (holds(corners, a) || holds(corners, b)) return true;
    for (std::size_t i = 0; i < 3; ++i)
        if (edgesMeet(a, b, corners[i], corners[(i + 1) % 3])) return true;
    return false;
}

// @param above, aboveTo  volumes of the face with both ends
bool edgeMeetsFace(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const FaceCorners& face,
                   double above, double aboveTo) {
    if ((above > 0 && aboveTo > 0) || (above < 0 && aboveTo < 0)) return false;
    if (above == 0 && aboveTo == 0) return meetsInPlane(from, to, face);
    return haveOneSign(volume(from, to, face[0], face[1]), volume(from, to, face[1], face[2]),
                       volume(from, to, face[2], face[0]));
}

std::array<double, 3> volumesOf(const FaceCorners& face, const FaceCorners& other) {
    return {volume(face, other[0]), volume(face, other[1]), volume(face, other[2])};
}

bool anyEdgeMeets(const FaceCorners& face, const FaceCorners& edges, const std::array<double, 3>& volumes) {
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        if (edgeMeetsFace(edges[i], edges[next], face, volumes[i], volumes[next])) return true;
    }
    return false;
}

}  // namespace

bool facesCross(const FaceCorners& one, const FaceCorners& other) {
    const std::array<double, 3> ofOther = volumesOf(one, other);
    if (areOnOneSide(ofOther)) return false;
    const std::array<double, 3> ofOne = volumesOf(other, one);
    if (areOnOneSide(ofOne)) return false;
    return anyEdgeMeets(one, other, ofOther) || anyEdgeMeets(other, one, ofOne);
}

std::optional<EdgeThroughFace> edgeThroughFace(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                               const FaceCorners& face) {
    const double above = volume(face, from), aboveTo = volume(face, to);
    if (above == aboveTo || !edgeMeetsFace(from, to, face, above, aboveTo)) return std::nullopt;
    const Eigen::Vector3d weights(volume(from, to, face[1], face[2]), volume(from, to, face[2], face[0]),
                                  volume(from, to, face[0], face[1]));
    const double sum = weights.sum();
    if (sum == 0) return std::nullopt;
    return EdgeThroughFace{above / (above - aboveTo), weights / sum};
}

}  // namespace drench
