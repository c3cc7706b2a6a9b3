#include "bullet/simd/strip_cloth.h"

#include <algorithm>
#include <cstring>

#include "bullet/simd/weight_table.h"

namespace drench {

StripPlateNodes plateNodesOf(const StripBlock<6>& block, int weights) {
    StripPlateNodes nodes = {};
    for (std::size_t k = 0; k < 6; ++k) {
        const bool isThere = block.vectors[k] >= 0;  // the weights of a node that is not are 0
        nodes.vectors[k] = isThere ? block.vectors[k] : block.vectors[0];
        nodes.turns[k] = static_cast<std::int8_t>(isThere ? block.turns[k] : 0);
        nodes.turned = nodes.turned || nodes.turns[k] != 0;
    }
    nodes.weights = weights;
    return nodes;
}

std::optional<StripCloth> StripCloth::of(const StripKernels& kernels, std::size_t nodes, const Links& links,
                                         const std::vector<PlateElement>& plates) {
    const Strips strips = stripsFor(links.nodes, nodes);
    if (strips.length == 0) return std::nullopt;
    return StripCloth(kernels, strips, links, plates);
}

StripCloth::StripCloth(const StripKernels& kernels, const Strips& strips, const Links& links,
                       const std::vector<PlateElement>& plates)
    : kernels_(kernels), strips_(strips) {
    EightNodes none, dry;
    std::memset(&none, 0, sizeof none);
    for (float* ratios : {dry.x, dry.y, dry.z}) std::fill(ratios, ratios + blockWidth, 1.0f);
    for (auto* nodes :
         {&start_, &moved_, &predicted_, &steps_, &push_, &pushAndMoments_, &ahead_, &expected_})
        nodes->assign(strips_.length, none);
    ratios_.assign(strips_.length, dry);
    inverseMass_.assign(strips_.length, EightNumbers{});
    packLinks(links);
    packPlates(plates);
}

void StripCloth::packLinks(const Links& links) {
    slotOfLink_.resize(links.nodes.size());
    for (const StripBlock<2>& block : stripBlocks(links.nodes, strips_)) {
        linkEnds_.push_back({block.vectors[0], block.vectors[1], block.turns[1]});
        std::memset(&links_.emplace_back(), 0, sizeof links_.back());
        EightNumbers& dry = dryStiffness_.emplace_back(EightNumbers{});
        for (std::size_t lane = 0; lane < blockWidth; ++lane) {
            if (block.elements[lane] < 0) continue;
            const auto link = static_cast<std::size_t>(block.elements[lane]);
            slotOfLink_[link] = (links_.size() - 1) * blockWidth + lane;
            dry.of[lane] = links.dry[link];
        }
    }
}

void StripCloth::packPlates(const std::vector<PlateElement>& plates) {
    std::vector<std::array<int, 6>> elements;
    for (const PlateElement& plate : plates) elements.push_back(plate.nodes);
    slotOfPlate_.resize(plates.size());
    WeightTable table;
    for (const StripBlock<6>& block : stripBlocks(elements, strips_)) {
        std::memset(&plates_.emplace_back(), 0, sizeof plates_.back());
        std::memset(&plateStates_.emplace_back(), 0, sizeof plateStates_.back());
        std::array<int, blockWidth> classes;
        for (std::size_t lane = 0; lane < blockWidth; ++lane) {
            classes[lane] = -1;
            if (block.elements[lane] < 0) continue;
            const auto plate = static_cast<std::size_t>(block.elements[lane]);
            slotOfPlate_[plate] = (plates_.size() - 1) * blockWidth + lane;
            classes[lane] = table.classOf(plates[plate]);
            plateStates_.back().area[lane] = float(plates[plate].area);
        }
        plateNodes_.push_back(plateNodesOf(block, table.of(classes, plateWeights_)));
    }
}

void StripCloth::setRestLength(std::size_t link, float length) {
    const std::size_t slot = slotOfLink_[link];
    links_[slot / blockWidth].restLength[slot % blockWidth] = length;
}

float& StripCloth::slid(std::size_t plate, std::size_t component) {
    const std::size_t slot = slotOfPlate_[plate];
    return plateStates_[slot / blockWidth].slid[component][slot % blockWidth];
}

StripNodes StripCloth::nodes() {
    return {moved_.data(),    predicted_.data(), steps_.data(),       ahead_.data(),
            expected_.data(), start_.data(),     inverseMass_.data(), strips_.length};
}

void StripCloth::begin(const Substep& substep) {
    kernels_.read(start_.data(), inverseMass_.data(), substep.start, strips_.length);
    kernels_.read(steps_.data(), nullptr, substep.steps, strips_.length);
    kernels_.read(push_.data(), nullptr, substep.push, strips_.length);
    kernels_.read(expected_.data(), nullptr, substep.middle, strips_.length);
    const float longest = substep.times.smallStep;
    kernels_.prepareLinks(links_.data(), linkEnds_.data(), dryStiffness_.data(), inverseMass_.data(),
                          ratios_.data(), longest * longest, links_.size());
    kernels_.preparePlates(push_.data(), plates_.data(), plateStates_.data(), plateNodes_.data(),
                           plateWeights_.data(), substep.laws, nodes(), ratios_.data(), substep.times,
                           plates_.size());
}

void StripCloth::read(const MovingNode* moved, const MovingNode* predicted) {
    kernels_.read(moved_.data(), nullptr, moved, strips_.length);
    kernels_.read(predicted_.data(), nullptr, predicted, strips_.length);
}

void StripCloth::writeMoved(MovingNode* moved) const {
    kernels_.write(moved, moved_.data(), inverseMass_.data(), strips_.length);
}

void StripCloth::writeMotion(MovingNode* predicted, MovingNode* steps) const {
    kernels_.write(predicted, predicted_.data(), inverseMass_.data(), strips_.length);
    kernels_.write(steps, steps_.data(), inverseMass_.data(), strips_.length);
}

void StripCloth::renewMoments(float steps) {
    kernels_.lookAhead(nodes(), steps);
    std::copy(push_.begin(), push_.end(), pushAndMoments_.begin());
    kernels_.solvePlates(pushAndMoments_.data(), ahead_.data(), inverseMass_.data(), plates_.data(),
                         plateNodes_.data(), plateWeights_.data(), plates_.size());
}

void StripCloth::advance(float keep, float fraction, bool keptMoments) {
    const EightNodes* const push = (keptMoments ? pushAndMoments_ : push_).data();
    if (fraction < 1)
        kernels_.advanceByFraction(nodes(), push, keep, fraction);
    else
        kernels_.advance(nodes(), push, keep);
}

void StripCloth::solve(float fraction, bool keptMoments) {
    EightNodes* const corrected = (fraction < 1 ? ahead_ : moved_).data();
    if (!keptMoments)
        kernels_.solvePlates(corrected, corrected, inverseMass_.data(), plates_.data(), plateNodes_.data(),
                             plateWeights_.data(), plates_.size());
    kernels_.solveLinks(corrected, start_.data(), inverseMass_.data(), links_.data(), linkEnds_.data(),
                        links_.size());
    if (fraction < 1) kernels_.correctByFraction(nodes(), fraction);
}

}  // namespace drench
