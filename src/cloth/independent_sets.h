// Greedy graph colouring: sets of mesh elements of which no two share a node.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace drench {

// Removes one set after the other from a list of elements; each set is a colour.
// @tparam Nodes  nodes of an element: 2 for a link, 3 for a triangle
template <std::size_t Nodes>
class IndependentSets {
  public:
    // @param elements  the nodes of each element; negative ones are ignored; must outlive this
    // @param nodes     number of nodes
    IndependentSets(const std::vector<std::array<int, Nodes>>& elements, std::size_t nodes)
        : elements_(elements), setOf_(nodes, -1) {}

    // Goes through the list in order, and removes each element that shares no node with those removed before
    // it.
    // @param waiting  indices of elements; those that are not removed stay
    // @return the removed indices
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
    std::vector<int> setOf_;  // last set that contains each node; -1 for none
    int set_ = -1;
};

}  // namespace drench
