// Greedy colouring: elements of a mesh in sets of which no two share a node.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace drench {

// Takes set after set off a list of elements; each is one colour.
// @tparam Nodes  of an element: 2 of a link, 3 of a triangle
template <std::size_t Nodes>
class IndependentSets {
  public:
    // @param elements  the nodes of each, of which negative ones do not count; they stay where they are
    // @param nodes     how many nodes there are
    IndependentSets(const std::vector<std::array<int, Nodes>>& elements, std::size_t nodes)
        : elements_(elements), setOf_(nodes, -1) {}

    // Goes through the list in its order, and takes each element that shares no node with those taken before it.
    // @param waiting  indices of elements; those that are not taken stay
    // @return indices of those that are
    std::vector<int> take(std::vector<int>& waiting) {
        ++set_;
        std::vector<int> taken;
        std::size_t left = 0;
        for (const int element : waiting) {
            const auto& nodes = elements_[static_cast<std::size_t>(element)];
            if (std::any_of(nodes.begin(), nodes.end(), [this](int node) { return isInSet(node); })) {
                waiting[left++] = element;
                continue;
            }
            for (const int node : nodes)
                if (node >= 0) setOf_[static_cast<std::size_t>(node)] = set_;
            taken.push_back(element);
        }
        waiting.resize(left);
        return taken;
    }

  private:
    bool isInSet(int node) const { return node >= 0 && setOf_[static_cast<std::size_t>(node)] == set_; }

    const std::vector<std::array<int, Nodes>>& elements_;
    std::vector<int> setOf_;  // the last set that has the node; -1 for none
    int set_ = -1;
};

}  // namespace drench
