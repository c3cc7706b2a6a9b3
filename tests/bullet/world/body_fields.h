// What a WetCloth changes of a body while it is attached.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

namespace drench::test {

// Inverse masses, links in their order, aero model and collision flags: equal ones are equal bit for bit.
inline std::vector<double> changedFields(const btSoftBody& body) {
    std::vector<double> fields = {double(body.m_cfg.kDG), double(body.m_cfg.kLF),
                                  double(body.m_cfg.collisions)};
    for (int n = 0; n < body.m_nodes.size(); ++n) fields.push_back(double(body.m_nodes[n].m_im));
    for (int i = 0; i < body.m_links.size(); ++i) {
        const btSoftBody::Link& link = body.m_links[i];
        for (const btSoftBody::Node* node : link.m_n) fields.push_back(double(node - &body.m_nodes[0]));
        for (const btScalar field : {link.m_rl, link.m_c0, link.m_c1}) fields.push_back(double(field));
    }
    return fields;
}

}  // namespace drench::test
