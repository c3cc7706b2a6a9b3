#include "stage/pictures.h"

#include <BulletSoftBody/btSoftBody.h>
#include <drench/wet_cloth.h>

#include <algorithm>
#include <cmath>

#include "world/vectors.h"

namespace drench::demo {

namespace {

viewer::Weave weaveOf(Construction construction) {
    switch (construction) {
        case Construction::plainWeave:
            return viewer::Weave::plain;
        case Construction::twill:
            return viewer::Weave::twill;
        case Construction::knit:
            return viewer::Weave::knit;
    }
    return viewer::Weave::plain;
}

template <typename Quantity>
std::vector<float> ofEachNode(const btSoftBody& body, const Quantity& quantity) {
    std::vector<float> result;
    result.reserve(static_cast<std::size_t>(body.m_nodes.size()));
    for (int node = 0; node < body.m_nodes.size(); ++node) result.push_back(float(quantity(node)));
    return result;
}

// Mean |strain| of the stretch and shear links at each node, %.
std::vector<float> strains(const btSoftBody& body) {
    std::vector<float> sums(static_cast<std::size_t>(body.m_nodes.size())), counts(sums.size());
    for (int l = 0; l < body.m_links.size(); ++l) {
        const btSoftBody::Link& link = body.m_links[l];
        if (link.m_bbending || !(link.m_rl > 0)) continue;
        const float length = float((link.m_n[1]->m_x - link.m_n[0]->m_x).length());
        for (const btSoftBody::Node* const end : link.m_n) {
            const auto node = static_cast<std::size_t>(end - &body.m_nodes[0]);
            sums[node] += 100 * std::abs(length / float(link.m_rl) - 1);
            counts[node] += 1;
        }
    }
    for (std::size_t node = 0; node < sums.size(); ++node) sums[node] /= std::max(counts[node], 1.0f);
    return sums;
}

// Largest moisture content of full pores, kg/kg.
float mostAbsorbent(const std::vector<const WetCloth*>& cloths) {
    double max = 0;
    for (const WetCloth* const cloth : cloths)
        max = std::max(max, cloth->fabric().poreCapacity() / cloth->fabric().arealDensity);
    return max > 0 ? float(max) : 1;
}

}  // namespace

viewer::SheetMesh sheetMesh(const btSoftBody& body, const Eigen::Vector3f& albedo) {
    viewer::SheetMesh mesh;
    for (int n = 0; n < body.m_nodes.size(); ++n)
        mesh.positions.push_back(pictureVector(body.m_nodes[n].m_x));
    mesh.albedo.assign(mesh.positions.size(), albedo);
    mesh.gloss.assign(mesh.positions.size(), 0);
    for (int f = 0; f < body.m_faces.size(); ++f) {
        std::array<std::uint32_t, 3> triangle;
        for (std::size_t corner = 0; corner < 3; ++corner)
            triangle[corner] = static_cast<std::uint32_t>(body.m_faces[f].m_n[corner] - &body.m_nodes[0]);
        mesh.triangles.push_back(triangle);
    }
    return mesh;
}

viewer::SheetMesh sheetMesh(const btSoftBody& body, const WetCloth& cloth, View view) {
    viewer::SheetMesh mesh = sheetMesh(body, Eigen::Vector3f::Zero());
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        const auto index = static_cast<std::size_t>(n);
        const Colour albedo = cloth.albedo(n);
        mesh.albedo[index] = {float(albedo[0]), float(albedo[1]), float(albedo[2])};
        mesh.gloss[index] = float(cloth.gloss(n));
        mesh.dampness.push_back(float(cloth.saturation(n)));
        mesh.transmittance.push_back(float(cloth.transmittance(n)));
        mesh.clothCoordinates.emplace_back(cloth.materialCoordinates()[index].cast<float>());
    }
    mesh.weave = weaveOf(cloth.fabric().construction);
    mesh.threadSpacing = float(cloth.fabric().threadSpacing);
    mesh.values = values(body, cloth, view);
    return mesh;
}

std::vector<float> values(const btSoftBody& body, const WetCloth& cloth, View view) {
    switch (view) {
        case View::beauty:
            return {};
        case View::content:
            return ofEachNode(body, [&](int node) { return cloth.moistureContent(node); });
        case View::film:
            return ofEachNode(body, [&](int node) {
                return 1e6 * cloth.moisture().filmThickness(static_cast<std::size_t>(node));
            });
        case View::strain:
            return strains(body);
    }
    return {};
}

std::optional<viewer::Legend> legend(View view, const std::vector<const WetCloth*>& cloths) {
    switch (view) {
        case View::beauty:
            return std::nullopt;
        case View::content:
            return viewer::Legend{"water content, kg/kg", 0, mostAbsorbent(cloths)};
        case View::film:
            return viewer::Legend{"film on a face, µm", 0, 200};
        case View::strain:
            return viewer::Legend{"mean strain, %", 0, 5};
    }
    return std::nullopt;
}

}  // namespace drench::demo
