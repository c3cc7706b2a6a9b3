// Prints the table of docs/stiffness.md: how far a hanging sheet sags with links of two kinds and substeps of several
// lengths, beside the same springs at rest in an independent solver. Takes about a minute and a half.
#include <cstdio>

#include "bullet/world/worlds.h"
#include "cloth/link_stiffness.h"
#include "static_equilibrium.h"

namespace drench::test {
namespace {

constexpr int nodesWarp = 55, nodesWeft = 45, heldNodes = 3;
constexpr double height = 3.6;  // m, of the upper edge

// Cotton that is equally stiff wet and dry, so that only weight differs.
Fabric cotton() {
    Fabric fabric = fabrics::cottonPlain();
    fabric.wetStretchRatio = 1;
    fabric.wetBendingRatio = 1;
    return fabric;
}

std::unique_ptr<btSoftBody> hung(btSoftBodyWorldInfo& info) {
    const double cell = std::sqrt(0.840e-3 / cotton().poreCapacity());
    auto sheet = makeSheet(info, cotton(),
                           flatCorners({0, btScalar(height), 0}, {btScalar(cell * (nodesWarp - 1)), 0, 0},
                                       {0, btScalar(-cell * (nodesWeft - 1)), 0}),
                           nodesWarp, nodesWeft);
    for (int i = 0; i < heldNodes; ++i) {
        sheet->m_nodes[i].m_im = 0;
        sheet->m_nodes[nodesWarp - 1 - i].m_im = 0;
    }
    return sheet;
}

// Dry stiffness of each link of a layer's body, N/m.
std::vector<double> stiffnessOf(const btSoftBody& sheet, const WetCloth& cloth) {
    const auto index = [&](const btSoftBody::Node* node) {
        return static_cast<int>(node - &sheet.m_nodes[0]);
    };
    std::vector<std::array<int, 3>> triangles;
    for (int f = 0; f < sheet.m_faces.size(); ++f) {
        const auto& corners = sheet.m_faces[f].m_n;
        triangles.push_back({index(corners[0]), index(corners[1]), index(corners[2])});
    }
    std::vector<LinkNodes> links;
    for (int i = 0; i < sheet.m_links.size(); ++i) {
        const btSoftBody::Link& link = sheet.m_links[i];
        links.push_back({{index(link.m_n[0]), index(link.m_n[1])}, link.m_bbending != 0, double(link.m_rl)});
    }
    std::vector<double> stiffness;
    const ClothMesh mesh = flatMesh(cloth.materialCoordinates(), triangles);
    for (const LinkStiffness& link : linkStiffness(cotton(), mesh, links)) stiffness.push_back(link.dry);
    return stiffness;
}

enum class LinkConstant { drench, xpbd };

// Sag of the upper edge's middle after six damped seconds, m.
double sagInBullet(LinkConstant kind, int substepsPerFrame, double fraction) {
    demo::BulletWorld bullet;
    const auto sheet = hung(bullet.world().getWorldInfo());
    bullet.world().addSoftBody(sheet.get());
    SheetSettings settings;
    settings.stepping = Stepping::byApplication;
    settings.waterSpeed = 0;  // the static solution knows no water that runs down
    auto cloth = std::make_unique<WetCloth>(bullet.world(), *sheet, cotton(), settings);
    cloth->soakPores(fraction * cotton().poreCapacity());
    const std::vector<double> stiffness = stiffnessOf(*sheet, *cloth);
    const double dt = 1.0 / 60 / substepsPerFrame;
    sheet->m_cfg.kDP = btScalar(3 * dt);
    for (int step = 0; step < 6 * 60 * substepsPerFrame; ++step) {
        cloth->preSubstep(btScalar(dt));
        for (int i = 0; kind == LinkConstant::xpbd && i < sheet->m_links.size(); ++i) {
            btSoftBody::Link& link = sheet->m_links[i];
            const double w = double(link.m_n[0]->m_im) + double(link.m_n[1]->m_im);
            if (w > 0) link.m_c0 = btScalar(w + 1 / (stiffness[std::size_t(i)] * dt * dt));
        }
        bullet.world().stepSimulation(btScalar(dt), 0);
    }
    cloth.reset();
    bullet.world().removeSoftBody(sheet.get());
    return height - double(sheet->m_nodes[nodesWarp / 2].m_x.y());
}

double sagAtRest(double fraction) {
    demo::BulletWorld bullet;
    const auto sheet = hung(bullet.world().getWorldInfo());
    SheetSettings settings;
    settings.stepping = Stepping::byApplication;
    settings.waterSpeed = 0;  // the static solution knows no water that runs down
    WetCloth cloth(bullet.world(), *sheet, cotton(), settings);
    cloth.soakPores(fraction * cotton().poreCapacity());
    const std::vector<double> stiffness = stiffnessOf(*sheet, cloth);
    StaticProblem problem;
    for (int n = 0; n < sheet->m_nodes.size(); ++n) {
        const btSoftBody::Node& node = sheet->m_nodes[n];
        problem.positions.emplace_back(node.m_x.x(), node.m_x.y(), node.m_x.z());
        problem.masses.push_back(cloth.nodeMass(n));
        problem.pinned.push_back(node.m_im == 0);
    }
    for (int i = 0; i < sheet->m_links.size(); ++i) {
        const btSoftBody::Link& link = sheet->m_links[i];
        problem.springs.push_back({{static_cast<int>(link.m_n[0] - &sheet->m_nodes[0]),
                                    static_cast<int>(link.m_n[1] - &sheet->m_nodes[0])},
                                   double(link.m_rl),
                                   stiffness[std::size_t(i)]});
    }
    return height - solveStatic(problem, 1e-6)[nodesWarp / 2].y();
}

}  // namespace
}  // namespace drench::test

int main() {
    using namespace drench::test;
    std::printf("at rest: dry %.4f m, saturated %.4f m\n", sagAtRest(0), sagAtRest(1));
    std::printf("substeps  XPBD dry  Drench dry  XPBD wet  Drench wet\n");
    for (const int substeps : {8, 16, 32, 64, 128}) {
        std::printf("%8d", substeps);
        for (const double fraction : {0.0, 1.0})
            for (const LinkConstant kind : {LinkConstant::xpbd, LinkConstant::drench})
                std::printf("  %8.4f", sagInBullet(kind, substeps, fraction));
        std::printf("\n");
        std::fflush(stdout);
    }
}
