// Times whole frames of a hanging sheet with the stock solver, dry, and with small steps, wet, in turns in one
// run; how far each is from rest as it should be; the hot loops by themselves; and the cost per node from small
// sheets to large ones. Takes two minutes or so; --nodes=N does all of it with sheets of N x N nodes only. All
// times are processor time of one thread.
#include <drench/drench.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "bullet/simd/independent_blocks.h"
#include "bullet/simd/small_step_kernels.h"
#include "cloth/link_stiffness.h"
#include "machine.h"
#include "static_equilibrium.h"
#include "world/bullet_world.h"

namespace drench::test {
namespace {

constexpr double frame = 1.0 / 60;  // s
constexpr double sideLength = 1;    // m
constexpr double wetness = 0.1;     // kg/m2
constexpr double ballRadius = 0.25;

double now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

// How a sheet is moved.
enum class Mover { stockInColours, stockInMeshOrder, smallSteps };

// A cotton sheet of a square metre, held at one edge. It hangs; or it is let go level, and falls on a ball.
class Hanging {
  public:
    Hanging(Mover mover, int nodes, int steps, bool withBall)
        : nodes_(nodes),
          fabric_(fabrics::cottonPlain()),
          solver_(settings(steps)),
          bullet_(mover == Mover::smallSteps ? &solver_ : nullptr) {
        sheet_ = makeSheet(bullet_.world().getWorldInfo(), fabric_,
                           flatCorners({btScalar(-sideLength / 2), 0, 0}, {btScalar(sideLength), 0, 0},
                                       withBall ? btVector3(0, 0, btScalar(sideLength))
                                                : btVector3(0, btScalar(-sideLength), 0)),
                           nodes, nodes);
        for (int i = 0; i < nodes; ++i) sheet_->m_nodes[i].m_im = 0;
        if (mover == Mover::stockInMeshOrder) putLinksInMeshOrder();
        if (mover != Mover::smallSteps) sheet_->m_cfg.piterations = 10;
        bullet_.world().addSoftBody(sheet_.get());
        if (withBall) ball_ = &bullet_.addBall({0, btScalar(-0.5), btScalar(0.5)}, ballRadius, 0);
        if (mover != Mover::smallSteps) return;
        cloth_ = std::make_unique<WetCloth>(bullet_.world(), *sheet_, fabric_);
        cloth_->soakFilm(wetness);
    }
    ~Hanging() { bullet_.world().removeSoftBody(sheet_.get()); }
    Hanging(const Hanging&) = delete;
    Hanging& operator=(const Hanging&) = delete;

    double timedFrame() {
        const double before = now();
        bullet_.step(frame, 1);
        return now() - before;
    }

    void comeToRest() {
        sheet_->m_cfg.kDP = btScalar(cloth_ ? 3 : 3 * frame);  // a rate here, a share a substep there
        for (int i = 0; i < 400; ++i) bullet_.step(frame, 1);
    }

    // Mean difference of the links' strains from those at rest.
    double strainError() const {
        const StaticProblem problem = atRest();
        const std::vector<Eigen::Vector3d> rest = solveStatic(problem, 1e-6);
        double sum = 0;
        for (const Spring& spring : problem.springs) {
            const auto a = std::size_t(spring.nodes[0]), b = std::size_t(spring.nodes[1]);
            const double expected = (rest[b] - rest[a]).norm() / spring.restLength;
            const double found =
                double(
                    (sheet_->m_nodes[spring.nodes[1]].m_x - sheet_->m_nodes[spring.nodes[0]].m_x).length()) /
                spring.restLength;
            sum += std::abs(found - expected);
        }
        return sum / double(problem.springs.size());
    }

    // How deep the deepest node is inside the ball, m.
    double penetration() const {
        double deepest = 0;
        if (!ball_) return 0;
        for (int n = 0; n < sheet_->m_nodes.size(); ++n)
            deepest = std::max(
                deepest,
                ballRadius -
                    double((sheet_->m_nodes[n].m_x - ball_->getWorldTransform().getOrigin()).length()));
        return deepest;
    }

    int links() const { return sheet_->m_links.size(); }
    int size() const { return sheet_->m_nodes.size(); }
    int steps() const { return solver_.steps(); }

  private:
    static SmallStepSettings settings(int steps) {
        SmallStepSettings settings;
        settings.count = steps;
        return settings;
    }

    // As Bullet's CreatePatch would have them: each node's together.
    void putLinksInMeshOrder() {
        btSoftBody::tLinkArray links;
        links.copyFromArray(sheet_->m_links);
        std::vector<int> order(static_cast<std::size_t>(links.size()));
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
        std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
            return std::min(links[a].m_n[0], links[a].m_n[1]) < std::min(links[b].m_n[0], links[b].m_n[1]);
        });
        for (int i = 0; i < links.size(); ++i) sheet_->m_links[i] = links[order[static_cast<std::size_t>(i)]];
    }

    // The same springs, as heavy and as stiff as they are now.
    StaticProblem atRest() const {
        const btSoftBody& body = *sheet_;
        StaticProblem problem;
        std::vector<Eigen::Vector2d> coordinates;
        for (int n = 0; n < body.m_nodes.size(); ++n) {
            const int row = n / nodes_, column = n % nodes_;
            const double x = sideLength * column / (nodes_ - 1) - sideLength / 2;
            const double y = -sideLength * row / (nodes_ - 1);
            problem.positions.emplace_back(x, y, 0);
            coordinates.emplace_back(x, -y);
            const btSoftBody::Node& node = body.m_nodes[n];
            problem.pinned.push_back(!(node.m_im > 0));
            problem.masses.push_back(node.m_im > 0 ? 1 / double(node.m_im) : 0);
        }
        std::vector<std::array<int, 3>> triangles;
        for (int f = 0; f < body.m_faces.size(); ++f)
            triangles.push_back({indexOf(body.m_faces[f].m_n[0]), indexOf(body.m_faces[f].m_n[1]),
                                 indexOf(body.m_faces[f].m_n[2])});
        std::vector<LinkNodes> links;
        for (int i = 0; i < body.m_links.size(); ++i) {
            const btSoftBody::Link& link = body.m_links[i];
            links.push_back(
                {{indexOf(link.m_n[0]), indexOf(link.m_n[1])}, link.m_bbending != 0, double(link.m_rl)});
        }
        const auto stiffness = linkStiffness(fabric_, flatMesh(coordinates, triangles), links);
        const WetLaws laws(fabric_);
        for (std::size_t i = 0; i < links.size(); ++i) {
            if (stiffness[i].kind == LinkKind::bending) continue;
            double ratio = 1;
            if (cloth_)
                ratio = 0.5 * (laws.stretchRatio(cloth_->moistureContent(links[i].nodes[0])) +
                               laws.stretchRatio(cloth_->moistureContent(links[i].nodes[1])));
            problem.springs.push_back({links[i].nodes, links[i].length, stiffness[i].dry * ratio});
        }
        return problem;
    }

    int indexOf(const btSoftBody::Node* node) const { return static_cast<int>(node - &sheet_->m_nodes[0]); }

    int nodes_;
    Fabric fabric_;
    SmallStepSolver solver_;
    demo::BulletWorld bullet_;
    btRigidBody* ball_ = nullptr;
    std::unique_ptr<btSoftBody> sheet_;
    std::unique_ptr<WetCloth> cloth_;
};

// A line of the table; what was not measured is less than 0.
struct Row {
    std::string name;
    int nodes;
    int steps;
    double frame = -1;        // ms
    double overStock = -1;    // of a frame of the stock solver, links in colours
    double strainError = -1;  // 1
    double penetration = -1;  // mm
    double perLink = -1;      // ns, a link and sweep
    double perNode = -1;      // ns, a node and frame
};

class Table {
  public:
    void add(const Row& row) {
        rows_.push_back(row);
        if (rows_.size() == 1) write(std::cout, rows_[0], true);
        write(std::cout, row, false);
        std::cout.flush();
    }
    bool save(const std::string& path) const {
        std::ofstream file(path + ".new");
        file << "machine,compiler,";
        write(file, rows_[0], true);
        for (const Row& row : rows_) {
            file << machine() << ',' << compiler() << ',';
            write(file, row, false);
        }
        file.close();
        return file && std::rename((path + ".new").c_str(), path.c_str()) == 0;
    }

  private:
    static void write(std::ostream& out, const Row& row, bool heading) {
        if (heading) {
            out << "case,nodes,small_steps,frame_ms,over_stock_frame,mean_strain_error,penetration_mm,"
                   "ns_per_link_and_sweep,ns_per_node_and_frame\n";
            return;
        }
        out << row.name << ',' << row.nodes << ',' << row.steps;
        for (const double value :
             {row.frame, row.overStock, row.strainError, row.penetration, row.perLink, row.perNode}) {
            out << ',';
            if (value >= 0) out << std::round(value * 1e5) / 1e5;
        }
        out << '\n';
    }

    std::vector<Row> rows_;
};

// Stock, dry, and small steps, wet, in turns.
void compareFrames(Table& table, int nodes, int steps, bool withBall) {
    Hanging colours(Mover::stockInColours, nodes, 0, withBall);
    Hanging meshOrder(Mover::stockInMeshOrder, nodes, 0, withBall);
    Hanging drench(Mover::smallSteps, nodes, steps, withBall);
    const int frames = nodes > 64 ? 120 : 300;
    std::array<std::vector<double>, 3> times;
    double deepest = 0, deepestStock = 0;
    for (int i = 0; i < frames; ++i) {
        times[0].push_back(colours.timedFrame());
        times[1].push_back(meshOrder.timedFrame());
        times[2].push_back(drench.timedFrame());
        deepest = std::max(deepest, drench.penetration());
        deepestStock = std::max(deepestStock, colours.penetration());
    }
    const double stock = median(times[0]);
    const std::string ball = withBall ? " with ball" : "";
    Row row{"stock dry" + ball, colours.size(), 0};
    row.frame = 1e3 * stock;
    row.overStock = 1;
    if (withBall) row.penetration = 1e3 * deepestStock;
    if (!withBall) {
        colours.comeToRest();
        row.strainError = colours.strainError();
    }
    table.add(row);

    row = {"stock dry in mesh order" + ball, meshOrder.size(), 0};
    row.frame = 1e3 * median(times[1]);
    row.overStock = median(times[1]) / stock;
    table.add(row);

    row = {"small steps wet" + ball, drench.size(), drench.steps()};
    row.frame = 1e3 * median(times[2]);
    row.overStock = median(times[2]) / stock;
    if (withBall) row.penetration = 1e3 * deepest;
    if (!withBall) {
        drench.comeToRest();
        row.strainError = drench.strainError();
    }
    table.add(row);
}

// Links of a grid, structural and both diagonals, packed as the solver packs them.
struct PackedGrid {
    explicit PackedGrid(int side) {
        std::vector<std::array<int, 2>> links;
        const auto add = [&](int i, int j, int di, int dj) {
            if (i + di < 0 || i + di >= side || j + dj >= side) return;
            links.push_back({i + j * side, i + di + (j + dj) * side});
        };
        for (const auto& step : {std::array<int, 2>{1, 0}, {0, 1}, {1, 1}, {-1, 1}})
            for (int j = 0; j < side; ++j)
                for (int i = 0; i < side; ++i) add(i, j, step[0], step[1]);
        const auto count = std::size_t(side * side);
        nodes.assign(count + 1, MovingNode{0, 0, 0, 1});
        std::mt19937 random(1);
        std::uniform_real_distribution<float> small(-1e-4f, 1e-4f);
        for (MovingNode& node : nodes) node.x = small(random), node.y = small(random), node.z = small(random);
        for (const IndependentBlock& chosen : independentBlocks(links, count)) {
            LinkBlock& block = blocks.emplace_back();
            block = {};
            for (std::size_t lane = 0; lane < blockWidth; ++lane) {
                block.first[lane] = block.second[lane] = std::int32_t(count);
                block.alongX[lane] = block.restLength[lane] = 0.01f;
                if (chosen[lane] < 0) continue;
                block.first[lane] = links[std::size_t(chosen[lane])][0];
                block.second[lane] = links[std::size_t(chosen[lane])][1];
                block.firstFraction[lane] = block.secondFraction[lane] = 0.3f;
            }
        }
        linkCount = links.size();
    }

    std::vector<MovingNode> nodes;
    std::vector<LinkBlock> blocks;
    std::size_t linkCount = 0;
};

void timeLoops(Table& table, int side) {
    PackedGrid grid(side);
    std::map<const SmallStepKernels*, std::vector<double>> times;
    for (int round = 0; round < 50; ++round)
        for (const SmallStepKernels* kernels : {&scalarKernels(), &bestKernels()}) {
            constexpr int sweeps = 20;
            const double before = now();
            for (int i = 0; i < sweeps; ++i)
                kernels->solveLinks(grid.nodes.data(), grid.blocks.data(), grid.blocks.size());
            times[kernels].push_back((now() - before) / sweeps);
        }
    for (const SmallStepKernels* kernels : {&scalarKernels(), &bestKernels()}) {
        Row row{std::string("links ") + kernels->name, side * side, 1};
        row.perLink = 1e9 * median(times[kernels]) / double(grid.linkCount);
        table.add(row);
    }
}

void timeSizes(Table& table, const std::vector<int>& sizes) {
    for (const int nodes : sizes) {
        Hanging drench(Mover::smallSteps, nodes, 20, false);
        drench.timedFrame();  // the one that packs the sheet
        std::vector<double> times;
        for (int i = 0; i < std::max(8, 100000 / (nodes * nodes)); ++i) times.push_back(drench.timedFrame());
        Row row{"small steps wet by size", drench.size(), drench.steps()};
        row.frame = 1e3 * median(times);
        row.perNode = 1e9 * median(times) / drench.size();
        table.add(row);
    }
}

// What the command line says.
struct Options {
    std::string csv;
    std::vector<int> compared{64, 128};              // nodes along a side
    std::vector<int> bySize{32, 64, 128, 256, 512};  // the same
};

// The number of nodes that a text says, or 0 if it says none from 4 to 1024.
int nodesFrom(const std::string& text) {
    if (text.empty() || text.size() > 4 || text.find_first_not_of("0123456789") != std::string::npos)
        return 0;
    const int nodes = std::stoi(text);
    return nodes >= 4 && nodes <= 1024 ? nodes : 0;
}

bool read(Options& options, const std::string& argument) {
    const std::size_t equals = argument.find('=');
    if (equals == std::string::npos) return false;
    const std::string name = argument.substr(0, equals), value = argument.substr(equals + 1);
    if (name == "--csv") options.csv = value;
    if (name == "--nodes") options.compared = options.bySize = {nodesFrom(value)};
    return (name == "--csv" && !value.empty()) || (name == "--nodes" && nodesFrom(value) > 0);
}

int run(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; ++i)
        if (!read(options, argv[i])) {
            std::cerr << argv[i] << ": not an option; --csv=PATH and --nodes=N, 4 to 1024, are\n";
            return 2;
        }
    std::cerr << machine() << ", " << compiler() << ", hot loops: " << bestKernels().name << '\n';
    Table table;
    for (const int nodes : options.compared) timeLoops(table, nodes);
    for (const int nodes : options.compared)
        for (const bool withBall : {false, true})
            for (const int steps : {20, 0}) compareFrames(table, nodes, steps, withBall);
    timeSizes(table, options.bySize);
    if (options.csv.empty() || table.save(options.csv)) return 0;
    std::cerr << "cannot write " << options.csv << '\n';
    return 1;
}

}  // namespace
}  // namespace drench::test

int main(int argc, char** argv) {
    return drench::test::run(argc, argv);
}
