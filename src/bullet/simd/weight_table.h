// The weights of plates, eight at a time.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include "bullet/simd/small_step_kernels.h"
#include "cloth/plate_bending.h"

namespace drench {

// Collects the weights of plates. On a regular mesh the same few weights occur again and again.
class WeightTable {
  public:
    // Index of the weights of a plate among those found so far, compared to four digits.
    int classOf(const PlateElement& plate) {
        double largest = 0;
        for (const auto& component : plate.weights)
            for (const double weight : component) largest = std::max(largest, std::abs(weight));
        constexpr double digits = 1e4;
        Key key;
        for (std::size_t m = 0; m < 3; ++m)
            for (std::size_t k = 0; k < 6; ++k)
                key[m * 6 + k] = std::lround(plate.weights[m][k] / largest * digits);
        key[18] = std::lround(std::log(largest) * digits);
        const auto [found, isNew] = classes_.emplace(key, static_cast<int>(plates_.size()));
        if (isNew) plates_.push_back(&plate);
        return found->second;
    }

    // Index of the weights of eight plates.
    int of(const std::array<int, blockWidth>& classes, std::vector<PlateWeights>& table) {
        const auto [found, isNew] = blocks_.emplace(classes, static_cast<int>(table.size()));
        if (!isNew) return found->second;
        PlateWeights weights = {};
        for (std::size_t lane = 0; lane < blockWidth; ++lane) {
            if (classes[lane] < 0) continue;
            const PlateElement& plate = *plates_[static_cast<std::size_t>(classes[lane])];
            for (std::size_t m = 0; m < 3; ++m)
                for (std::size_t k = 0; k < 6; ++k) weights.of[m][k][lane] = float(plate.weights[m][k]);
        }
        table.push_back(weights);
        return found->second;
    }

  private:
    using Key = std::array<long, 19>;
    std::map<Key, int> classes_;
    std::vector<const PlateElement*> plates_;
    std::map<std::array<int, blockWidth>, int> blocks_;
};

}  // namespace drench
