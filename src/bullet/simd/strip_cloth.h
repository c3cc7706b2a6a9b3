// The links and plates of a sheet in strips, and its nodes while small steps move it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "bullet/simd/small_step_kernels.h"
#include "bullet/simd/strips.h"
#include "cloth/plate_bending.h"

namespace drench {

// The vectors of eight plates as the inner loops read them.
// @param weights  index of their weights
StripPlateNodes plateNodesOf(const StripBlock<6>& block, int weights);

// A sweep over links or plates is over `StripBlock`s: in tiles of neighbouring nodes, by colours within a tile.
//
// Each link has one number of its own, `StripLinks::share`, for a small step: how much of its stretch its two nodes
// correct, over their inverse masses. `StripKernels::prepareLinks` computes it from the stiffness of the link at the
// start of the substep; see linkDivisor.
class StripCloth {
  public:
    struct Links {
        const std::vector<std::array<int, 2>>& nodes;
        const std::vector<float>& dry;  // stiffness of the dry cloth, N/m
    };
    // @return nothing if the mesh does not repeat itself enough
    static std::optional<StripCloth> of(const StripKernels& kernels, std::size_t nodes, const Links& links,
                                        const std::vector<PlateElement>& plates);

    // Number of nodes that the arrays below have, with those that are missing in the last strips: these are at 0, and
    // have an inverse mass of 0.
    std::size_t slots() const { return strips_.slots(); }
    // By the index of the link.
    void setRestLength(std::size_t link, float length);
    // Curvature at which the friction moment of a plate is 0, 1/m. By the index of the plate.
    float& slid(std::size_t plate, std::size_t component);
    // @param of  the ratios of wet to dry of each node, by its index: stretch, bending and bending friction
    template <typename Of>
    void setRatios(std::size_t nodes, Of of) {
        for (std::size_t n = 0; n < nodes; ++n) {
            EightNodes& to = ratios_[strips_.vectorOf(n)];
            const std::size_t lane = strips_.laneOf(n);
            const std::array<float, 3> ratios = of(n);
            to.x[lane] = ratios[0];
            to.y[lane] = ratios[1];
            to.z[lane] = ratios[2];
        }
    }

    // What a substep begins with; nodes in their order.
    struct Substep {
        const MovingNode* start;   // positions, m, and inverse masses
        const MovingNode* steps;   // displacement per small step, m
        const MovingNode* push;    // m per small step
        const MovingNode* middle;  // positions in the middle of the substep, m
        PlateLaws laws;
        PlateTimes times;  // of the longest small step
    };
    void begin(const Substep& substep);

    // Displacements of nodes, and those before corrections, which others may have changed.
    void read(const MovingNode* moved, const MovingNode* predicted);
    void writeMoved(MovingNode* moved) const;
    // Displacements before corrections, and the last small step's.
    void writeMotion(MovingNode* predicted, MovingNode* steps) const;

    // Computes the moments of plates that are kept from where the nodes will be after some more steps.
    void renewMoments(float steps);
    // The parts of a small step, which is that fraction of the longest one.
    // @param keptMoments  whether those of plates are kept, or renewed in each step
    void advance(float keep, float fraction, bool keptMoments);
    void solve(float fraction, bool keptMoments);

  private:
    StripCloth(const StripKernels& kernels, const Strips& strips, const Links& links,
               const std::vector<PlateElement>& plates);
    void packLinks(const Links& links);
    void packPlates(const std::vector<PlateElement>& plates);
    StripNodes nodes();

    StripKernels kernels_;
    Strips strips_;
    std::vector<EightNodes> start_, moved_, predicted_, steps_, push_, pushAndMoments_, ahead_, expected_,
        ratios_;
    std::vector<EightNumbers> inverseMass_;

    std::vector<StripLinkEnds> linkEnds_;
    std::vector<StripLinks> links_;
    std::vector<EightNumbers> dryStiffness_;  // N/m
    std::vector<std::size_t> slotOfLink_;

    std::vector<StripPlateNodes> plateNodes_;
    std::vector<StripPlates> plates_;
    std::vector<PlateState> plateStates_;
    std::vector<PlateWeights> plateWeights_;
    std::vector<std::size_t> slotOfPlate_;
};

}  // namespace drench
