// Sets of nodes that hang together.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace drench {

class Pieces {
  public:
    explicit Pieces(std::size_t nodes) : parents_(nodes) { std::iota(parents_.begin(), parents_.end(), 0); }

    void join(int a, int b) { parent(of(a)) = of(b); }

    // A node of the piece of a node: the same one for all nodes of the piece, until the next call of `join`.
    int of(int node) {
        while (parent(node) != node) node = parent(node) = parent(parent(node));
        return node;
    }

  private:
    int& parent(int node) { return parents_[static_cast<std::size_t>(node)]; }

    std::vector<int> parents_;
};

}  // namespace drench
