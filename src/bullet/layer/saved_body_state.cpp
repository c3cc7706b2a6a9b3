#include "bullet/layer/saved_body_state.h"

#include "bullet/sheet/link_order.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

std::vector<int> orderOfColours(const RestShape& shape) {
    std::vector<std::array<int, 2>> links;
    links.reserve(shape.links.size());
    for (const LinkNodes& link : shape.links) links.push_back(link.nodes);
    return colouredOrder(links, static_cast<int>(shape.nodeAreas.size()));
}

template <typename Value>
std::vector<Value> reordered(const std::vector<Value>& values, const std::vector<int>& order) {
    std::vector<Value> result;
    result.reserve(values.size());
    for (const int from : order) result.push_back(values[static_cast<std::size_t>(from)]);
    return result;
}

}  // namespace

SavedBodyState::SavedBodyState(btSoftBody& body, SheetMechanics& mechanics) {
    for (int i = 0; i < body.m_links.size(); ++i) linkOrder_.push_back(i);
    prime(body);
    orderLinks(body, mechanics);
    for (int n = 0; n < body.m_nodes.size(); ++n) inverseMasses_.push_back(body.m_nodes[n].m_im);
    for (int i = 0; i < body.m_links.size(); ++i) linkConstants_.push_back(body.m_links[i].m_c0);
    drag_ = body.m_cfg.kDG;
    lift_ = body.m_cfg.kLF;
    body.m_cfg.kDG = 0;
    body.m_cfg.kLF = 0;
}

void SavedBodyState::orderLinks(btSoftBody& body, SheetMechanics& mechanics) {
    const std::vector<int> order = orderOfColours(mechanics.shape);
    reorderLinks(body, order);
    mechanics.shape.links = reordered(mechanics.shape.links, order);
    mechanics.shape.restLengths = reordered(mechanics.shape.restLengths, order);
    mechanics.dryStiffness = reordered(mechanics.dryStiffness, order);
    linkOrder_ = reordered(linkOrder_, order);
}

void SavedBodyState::recut(btSoftBody& body, SheetMechanics& mechanics, const std::vector<double>& oldAreas,
                           const std::vector<double>& dryMasses) {
    const auto links = static_cast<std::size_t>(body.m_links.size());
    if (links < linkOrder_.size())
        linkOrder_.clear();  // links have been removed, so the original order cannot be restored
    while (linkOrder_.size() < links) linkOrder_.push_back(static_cast<int>(linkOrder_.size()));
    orderLinks(body, mechanics);
    for (std::size_t n = 0; n < dryMasses.size(); ++n) {
        const double area = mechanics.mesh.areas[n];
        if (n >= inverseMasses_.size())
            inverseMasses_.push_back(dryMasses[n] > 0 ? btScalar(1 / dryMasses[n])
                                                      : body.m_nodes[static_cast<int>(n)].m_im);
        else if (area > 0 && oldAreas[n] > 0)
            inverseMasses_[n] *= btScalar(oldAreas[n] / area);
    }
    linkConstants_.clear();
    for (int i = 0; i < body.m_links.size(); ++i) {
        const btSoftBody::Link& link = body.m_links[i];
        const btScalar sum = inverseMasses_[static_cast<std::size_t>(indexOf(body, link.m_n[0]))] +
                             inverseMasses_[static_cast<std::size_t>(indexOf(body, link.m_n[1]))];
        linkConstants_.push_back(sum / link.m_material->m_kLST);
    }
}

void SavedBodyState::silenceAero(btSoftBody& body) {
    if (body.m_cfg.kDG != 0) drag_ = body.m_cfg.kDG;
    if (body.m_cfg.kLF != 0) lift_ = body.m_cfg.kLF;
    body.m_cfg.kDG = 0;
    body.m_cfg.kLF = 0;
}

void SavedBodyState::restore(btSoftBody& body, const std::vector<double>& dryMasses) const {
    body.m_cfg.kDG = drag_;
    body.m_cfg.kLF = lift_;
    // In a body whose topology has changed, nothing else can be assigned any more.
    if (body.m_nodes.size() != static_cast<int>(inverseMasses_.size()) ||
        body.m_links.size() != static_cast<int>(linkConstants_.size()))
        return;

    std::vector<bool> pinChanged(inverseMasses_.size());
    for (int i = 0; i < body.m_nodes.size(); ++i) {
        const auto n = static_cast<std::size_t>(i);
        btScalar& inverseMass = body.m_nodes[i].m_im;
        pinChanged[n] = (inverseMass > 0) != (inverseMasses_[n] > 0);
        if (!pinChanged[n])
            inverseMass = inverseMasses_[n];
        else if (inverseMass > 0 && dryMasses[n] > 0)
            inverseMass = btScalar(1 / dryMasses[n]);
    }
    for (int i = 0; i < body.m_links.size(); ++i) {
        btSoftBody::Link& link = body.m_links[i];
        const bool changed = pinChanged[static_cast<std::size_t>(indexOf(body, link.m_n[0]))] ||
                             pinChanged[static_cast<std::size_t>(indexOf(body, link.m_n[1]))];
        link.m_c0 = changed ? (link.m_n[0]->m_im + link.m_n[1]->m_im) / link.m_material->m_kLST
                            : linkConstants_[static_cast<std::size_t>(i)];
    }
    reorderLinks(body, inverseOrder(linkOrder_));
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
