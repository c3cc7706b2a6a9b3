#include "measure/silhouette.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "world/angles.h"

namespace drench::demo {

namespace {

void drawCircle(viewer::Image& image, double radius) {
    constexpr std::uint8_t colour[] = {200, 60, 40};
    const double middle = image.width / 2.0;
    constexpr double width = 1.2;  // pixels
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double distance = std::hypot(x + 0.5 - middle, y + 0.5 - middle);
            if (std::abs(distance - radius) < width)
                std::copy_n(colour, 3, image.rgb.begin() + 3 * (std::ptrdiff_t(y) * image.width + x));
        }
}

}  // namespace

Silhouette::Silhouette(const btSoftBody& sheet, const Eigen::Vector2d& centre, double reach, int pixels)
    : centre_(centre),
      reach_(reach),
      pixels_(pixels),
      covered_(std::size_t(pixels) * std::size_t(pixels), 0) {
    for (int f = 0; f < sheet.m_faces.size(); ++f) {
        const auto& corners = sheet.m_faces[f].m_n;
        cover(projected(corners[0]->m_x), projected(corners[1]->m_x), projected(corners[2]->m_x));
    }
}

Eigen::Vector2d Silhouette::projected(const btVector3& position) const {
    const Eigen::Vector2d flat(double(position.x()), double(position.z()));
    return (flat - centre_ + Eigen::Vector2d::Constant(reach_)) / pixelSize();
}

void Silhouette::cover(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    const double last = pixels_ - 1;
    const auto firstFrom = [&](double value) {
        return int(std::ceil(std::clamp(value - 0.5, 0., last + 1)));
    };
    const auto lastTo = [&](double value) { return int(std::floor(std::clamp(value - 0.5, -1., last))); };
    for (int y = firstFrom(std::min({a.y(), b.y(), c.y()})); y <= lastTo(std::max({a.y(), b.y(), c.y()}));
         ++y) {
        double from = pixels_, to = 0;  // where the centre line of the row enters and leaves the triangle
        const auto cross = [&](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
            const double height = y + 0.5;
            if ((p.y() <= height) == (q.y() <= height)) return;
            const double x = p.x() + (height - p.y()) / (q.y() - p.y()) * (q.x() - p.x());
            from = std::min(from, x);
            to = std::max(to, x);
        };
        cross(a, b);
        cross(b, c);
        cross(c, a);
        for (int x = firstFrom(from); x <= lastTo(to); ++x)
            covered_[std::size_t(y) * std::size_t(pixels_) + std::size_t(x)] = 1;
    }
}

double Silhouette::area() const {
    return double(std::count(covered_.begin(), covered_.end(), 1)) * pixelSize() * pixelSize();
}

std::vector<double> Silhouette::radii(int directions) const {
    std::vector<double> result;
    for (int i = 0; i < directions; ++i) {
        const double angle = 2 * pi * i / directions;
        const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
        constexpr double step = 0.25;  // pixels
        double distance = pixels_ / 2.0 - 1;
        for (; distance > 0; distance -= step) {
            const Eigen::Vector2d p = distance * along + Eigen::Vector2d::Constant(pixels_ / 2.0);
            if (covered_[std::size_t(p.y()) * std::size_t(pixels_) + std::size_t(p.x())]) break;
        }
        result.push_back(distance * pixelSize());
    }
    return result;
}

viewer::Image Silhouette::image(const std::vector<double>& circles) const {
    viewer::Image image{pixels_, pixels_, {}};
    for (const unsigned char covered : covered_)
        image.rgb.insert(image.rgb.end(), 3, covered ? std::uint8_t(0) : std::uint8_t(255));
    for (const double circle : circles) drawCircle(image, circle / pixelSize());
    return image;
}

int countLobes(const std::vector<double>& radii, double prominence) {
    // Goes around once from the lowest point. A lobe starts where the radius has risen by the prominence, and
    // ends where it has fallen by it.
    const std::size_t count = radii.size();
    const auto lowest = std::size_t(std::min_element(radii.begin(), radii.end()) - radii.begin());
    int lobes = 0;
    bool climbing = true;
    double extreme = radii[lowest];  // minimum since the last lobe, or maximum of this one
    for (std::size_t i = 1; i <= count; ++i) {
        const double radius = radii[(lowest + i) % count];
        if (climbing) {
            extreme = std::min(extreme, radius);
            if (radius < extreme + prominence) continue;
        } else {
            extreme = std::max(extreme, radius);
            if (radius > extreme - prominence) continue;
            ++lobes;
        }
        climbing = !climbing;
        extreme = radius;
    }
    return lobes;
}

int dominantOrder(const std::vector<double>& radii, int max) {
    int dominant = 1;
    double largest = 0;
    for (int order = 1; order <= max; ++order) {
        std::complex<double> sum = 0;
        for (std::size_t i = 0; i < radii.size(); ++i)
            sum += std::polar(radii[i], -2 * pi * order * double(i) / double(radii.size()));
        if (std::abs(sum) <= largest) continue;
        largest = std::abs(sum);
        dominant = order;
    }
    return dominant;
}

}  // namespace drench::demo
