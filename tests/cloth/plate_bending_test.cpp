#include "cloth/plate_bending.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>

#include "meshes.h"

namespace drench::plate_bending_test {
namespace {

using meshes::Disorder;
using meshes::LaidOut;

constexpr double degree = 3.14159265358979323846 / 180;
constexpr Disorder mild{0.2, 0.0, false};
constexpr std::array<double, 5> directions = {0, 30, 45, 90, -45};

std::size_t index(int node) {
    return static_cast<std::size_t>(node);
}

// Whether all three edges have a neighbour; not for meshes where far corners meet.
bool isInner(const PlateElement& element) {
    return element.nodes[3] >= 0 && element.nodes[4] >= 0 && element.nodes[5] >= 0;
}

std::vector<double> sampled(const LaidOut& mesh,
                            const std::function<double(const Eigen::Vector2d&)>& function) {
    std::vector<double> values;
    for (const Eigen::Vector2d& position : mesh.positions) values.push_back(function(position));
    return values;
}

Eigen::Vector3d curvature(const PlateElement& element, const std::vector<double>& heights) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t m = 0; m < 3; ++m)
        for (std::size_t k = 0; k < 6; ++k)
            if (element.nodes[k] >= 0)
                sum[static_cast<Eigen::Index>(m)] += element.weights[m][k] * heights[index(element.nodes[k])];
    return sum;
}

// Energy of one element for B = 1 N m.
double energy(const PlateElement& element, const std::vector<Eigen::Vector3d>& positions) {
    double sum = 0;
    for (const auto& weights : element.weights) {
        Eigen::Vector3d bend = Eigen::Vector3d::Zero();
        for (std::size_t k = 0; k < 6; ++k)
            if (element.nodes[k] >= 0) bend += weights[k] * positions[index(element.nodes[k])];
        sum += bend.squaredNorm();
    }
    return 0.5 * element.area * sum;
}

double energy(const std::vector<PlateElement>& elements, const std::vector<Eigen::Vector3d>& positions) {
    double sum = 0;
    for (const PlateElement& element : elements) sum += energy(element, positions);
    return sum;
}

std::vector<Eigen::Vector3d> flat(const LaidOut& mesh) {
    std::vector<Eigen::Vector3d> positions;
    for (const Eigen::Vector2d& position : mesh.positions)
        positions.emplace_back(position.x(), position.y(), 0);
    return positions;
}

std::vector<Eigen::Vector3d> crumpled(const LaidOut& mesh, double height) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> shift(-height, height);
    std::vector<Eigen::Vector3d> positions = flat(mesh);
    for (Eigen::Vector3d& position : positions)
        position += Eigen::Vector3d(shift(random), shift(random), shift(random));
    return positions;
}

// Matrix of the energy of small heights, for B = 1 N m.
Eigen::SparseMatrix<double> stiffnessMatrix(const std::vector<PlateElement>& elements, std::size_t size) {
    std::vector<Eigen::Triplet<double>> entries;
    for (const PlateElement& element : elements)
        for (const auto& weights : element.weights)
            for (std::size_t i = 0; i < 6; ++i)
                for (std::size_t j = 0; j < 6; ++j)
                    if (element.nodes[i] >= 0 && element.nodes[j] >= 0)
                        entries.emplace_back(element.nodes[i], element.nodes[j],
                                             element.area * weights[i] * weights[j]);
    const auto count = static_cast<Eigen::Index>(size);
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

// Heights under a load on each node, in N for B = 1 N m, with some nodes held at 0.
std::vector<double> deflection(const LaidOut& mesh, const std::vector<double>& load,
                               const std::vector<bool>& held) {
    const std::size_t size = mesh.positions.size();
    Eigen::SparseMatrix<double> matrix = stiffnessMatrix(plateElements(mesh.cloth), size);
    Eigen::VectorXd force(static_cast<Eigen::Index>(size));
    for (std::size_t i = 0; i < size; ++i) force[static_cast<Eigen::Index>(i)] = held[i] ? 0 : load[i];
    matrix.prune([&](Eigen::Index row, Eigen::Index column, double) {
        return row == column ||
               (!held[static_cast<std::size_t>(row)] && !held[static_cast<std::size_t>(column)]);
    });
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    EXPECT_EQ(solver.info(), Eigen::Success);
    const Eigen::VectorXd heights = solver.solve(force);
    return {heights.begin(), heights.end()};
}

// A strip along its first axis, clamped at the near end; below, its tip deflection over that of a beam.
struct Strip {
    LaidOut mesh;
    double clampedAt;  // the two columns up to here are held; their mirror lies half way between them, m
    double length;     // m
};

double underOwnWeight(const Strip& strip) {
    std::vector<bool> held;
    double tip = 0, count = 0;
    for (const Eigen::Vector2d& position : strip.mesh.positions)
        held.push_back(position.x() < strip.clampedAt);
    const std::vector<double> heights = deflection(strip.mesh, strip.mesh.cloth.areas, held);
    double heldUpTo = 0, heldCount = 0;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const double x = strip.mesh.positions[i].x();
        if (x > strip.length - 1e-9) {
            tip += heights[i];
            ++count;
        } else if (held[i] && x > 1e-9) {
            heldUpTo += x;
            ++heldCount;
        }
    }
    const double length = strip.length - 0.5 * heldUpTo / heldCount;
    return tip / count / (std::pow(length, 4) / 8);
}

double underTipLoad(const Strip& strip, double width) {
    std::vector<bool> held;
    std::vector<double> load;
    double count = 0;
    for (const Eigen::Vector2d& position : strip.mesh.positions) {
        held.push_back(position.x() < strip.clampedAt);
        const bool atTip = position.x() > strip.length - 1e-9;
        const bool atCorner = position.y() < 1e-9 || position.y() > width - 1e-9;
        load.push_back(!atTip ? 0 : atCorner ? 0.5 : 1);
        count += load.back();
    }
    const std::vector<double> heights = deflection(strip.mesh, load, held);
    double tip = 0;
    for (std::size_t i = 0; i < heights.size(); ++i) tip += heights[i] * load[i] / count;
    const double length = strip.length - strip.clampedAt / 3;  // half way along the first column of cells
    return tip / (count / width * std::pow(length, 3) / 3);
}

// A strip of 1 m by 0.25 m whose cells lie square to it.
Strip along(int cells) {
    const double spacing = 1.0 / cells;
    return {meshes::grid(cells + 1, cells / 4 + 1, spacing), 1.5 * spacing, 1.0};
}

// The same with the longer edge in the direction that rows of the grid follow each other.
Strip acrossRows(int cells) {
    const double spacing = 1.0 / cells;
    Strip strip{meshes::grid(cells / 4 + 1, cells + 1, spacing), 1.5 * spacing, 1.0};
    for (Eigen::Vector2d& position : strip.mesh.positions)
        position = Eigen::Vector2d(position.y(), position.x());
    return strip;
}

Strip irregularStrip(int cells, unsigned seed, const Disorder& disorder) {
    const double spacing = 1.0 / cells;
    return {meshes::irregular(cells + 1, cells / 4 + 1, spacing, seed, disorder), 1.5 * spacing, 1.0};
}

// A strip cut out of a grid at 45 degrees, half cells at both ends; the weave is turned with the grid.
Strip bias(int cells) {
    const double spacing = 1.0 / (2 * cells);  // of rows, and of columns of nodes
    const int rows = cells / 2 + 1;
    LaidOut mesh;
    std::vector<std::vector<int>> nodes(static_cast<std::size_t>(rows));
    for (int row = 0; row < rows; ++row) {
        const auto put = [&](double column) {
            nodes[index(row)].push_back(static_cast<int>(mesh.positions.size()));
            mesh.positions.emplace_back(column * spacing, row * spacing);
        };
        if (row % 2 == 1) put(0);
        for (int cell = 0; cell < cells; ++cell) put(2 * cell + row % 2);
        put(2 * cells);
    }
    std::vector<std::array<int, 3>> triangles;
    for (int row = 0; row + 1 < rows; ++row) {
        const auto &below = nodes[index(row)], &above = nodes[index(row + 1)];
        std::size_t i = 0, j = 0;
        const auto position = [&](int node) { return mesh.positions[index(node)].x(); };
        while (i + 1 < below.size() || j + 1 < above.size()) {
            const bool alongBelow =
                j + 1 == above.size() ||
                (i + 1 < below.size() && position(below[i + 1]) < position(above[j + 1]) + 1e-9 * spacing);
            triangles.push_back({below[i], alongBelow ? below[i + 1] : above[j + 1], above[j]});
            ++(alongBelow ? i : j);
        }
    }
    mesh.cloth = flatMesh(mesh.positions, triangles);
    return {meshes::rotated(mesh, 45 * degree), 1.5 * spacing, 1.0};
}

// Deflection of the middle of a square plate under an even load, over that of the exact one.
double plate(const LaidOut& mesh, int cells, bool clamped) {
    std::vector<bool> held;
    for (int row = 0; row <= cells; ++row)
        for (int column = 0; column <= cells; ++column) {
            const int depth = std::min({column, cells - column, row, cells - row});
            held.push_back(depth < (clamped ? 2 : 1));
        }
    const auto heights = deflection(mesh, mesh.cloth.areas, held);
    const double side =
        clamped ? 1 - 1.0 / cells : 1;  // clamped half way between the two rings that are held
    const double exact = clamped ? 0.00126532 : 0.00406235;  // Timoshenko and Woinowsky-Krieger
    return heights[index(meshes::nodeAt(cells / 2, cells / 2, cells + 1))] / (exact * std::pow(side, 4));
}

// Energy of a bend in one direction, in all inner elements, over that of the cloth.
double bendRatio(const LaidOut& mesh, double direction) {
    const Eigen::Vector2d normal(std::cos(direction), std::sin(direction));
    const auto heights = sampled(
        mesh, [&](const Eigen::Vector2d& position) { return 0.5 * std::pow(normal.dot(position), 2); });
    double sum = 0, area = 0;
    for (const PlateElement& element : plateElements(mesh.cloth)) {
        if (!isInner(element)) continue;
        sum += element.area * curvature(element, heights).squaredNorm();
        area += element.area;
    }
    return sum / area;
}

TEST(PlateBending, NothingIsBentByMovingTurningOrStretchingEvenly) {
    for (const LaidOut& mesh : {meshes::grid(9, 7, 0.02), meshes::irregular(9, 7, 0.02, 1)}) {
        const auto elements = plateElements(mesh.cloth);
        EXPECT_EQ(elements.size(), mesh.cloth.triangles.size());
        auto moved = flat(mesh);
        const Eigen::Matrix3d turn(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
        for (Eigen::Vector3d& position : moved)
            position =
                turn * Eigen::Vector3d(1.1 * position.x() + 0.1 * position.y(), 0.9 * position.y(), 0) +
                Eigen::Vector3d(3, 2, 1);
        for (const PlateElement& element : elements)
            for (const auto& weights : element.weights) {
                double sum = 0, size = 0;
                for (const double weight : weights) {
                    sum += weight;
                    size += std::abs(weight);
                }
                EXPECT_LE(std::abs(sum), 1e-13 * size);
            }
        EXPECT_LT(energy(elements, moved), 1e-18 * energy(elements, crumpled(mesh, 0.01)));
    }
}

TEST(PlateBending, AGridIsEquallyStiffInAllDirections) {
    for (const double direction : directions)
        EXPECT_NEAR(bendRatio(meshes::grid(21, 21, 0.01), direction * degree), 1, 1e-9);
    // So it is where all triangles are the same, but not right-angled.
    LaidOut sheared = meshes::grid(21, 21, 0.01);
    for (Eigen::Vector2d& position : sheared.positions)
        position = {position.x() + 0.4 * position.y(), 0.8 * position.y()};
    sheared.cloth = flatMesh(sheared.positions, sheared.cloth.triangles);
    for (const double direction : directions) EXPECT_NEAR(bendRatio(sheared, direction * degree), 1, 1e-9);
}

TEST(PlateBending, AnIrregularMeshIsAlmostEquallyStiffInAllDirections) {
    for (const double direction : directions) {
        const double mildRatio = bendRatio(meshes::irregular(31, 31, 0.01, 1, mild), direction * degree);
        const double ratio = bendRatio(meshes::irregular(31, 31, 0.01, 1), direction * degree);
        std::printf("bend in direction %3.0f: mildly irregular %.3f, badly cut %.3f\n", direction, mildRatio,
                    ratio);
        EXPECT_NEAR(mildRatio, 1, 0.03);
        EXPECT_NEAR(ratio, 1, 0.2);
    }
}

TEST(PlateBending, CurvatureIsInTheAxesOfTheWeave) {
    const LaidOut mesh = meshes::rotatedGrid(5, 5, 0.01, 30 * degree);
    const auto heights =
        sampled(mesh, [](const Eigen::Vector2d& position) { return position.x() * position.x(); });
    const double cosine = std::cos(30 * degree), sine = std::sin(30 * degree);
    int inner = 0;
    for (const PlateElement& element : plateElements(mesh.cloth)) {
        if (!isInner(element)) continue;
        ++inner;
        const Eigen::Vector3d found = curvature(element, heights);
        EXPECT_NEAR(found[0], 2 * cosine * cosine, 1e-9);
        EXPECT_NEAR(found[1], 2 * sine * sine, 1e-9);
        EXPECT_NEAR(found[2], 2 * std::sqrt(2.0) * sine * cosine, 1e-9);
    }
    EXPECT_GT(inner, 10);
}

TEST(PlateBending, OnABorderOnlyCurvatureAcrossItIsFree) {
    const int columns = 6, rows = 5;
    const double spacing = 0.01;
    const LaidOut mesh = meshes::grid(columns, rows, spacing);
    const auto heights = sampled(mesh, [](const Eigen::Vector2d& position) {
        return 0.5 * (3 * position.x() * position.x() + 5 * position.y() * position.y()) +
               7 * position.x() * position.y();
    });
    for (const PlateElement& element : plateElements(mesh.cloth)) {
        int left = 0, right = 0, below = 0, above = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const int column = element.nodes[i] % columns, row = element.nodes[i] / columns;
            left += column == 0;
            right += column == columns - 1;
            below += row == 0;
            above += row == rows - 1;
        }
        const Eigen::Vector3d found = curvature(element, heights);
        EXPECT_NEAR(found[0], left == 2 || right == 2 ? 0 : 3, 1e-9);
        EXPECT_NEAR(found[1], below == 2 || above == 2 ? 0 : 5, 1e-9);
        EXPECT_NEAR(found[2], 7 * std::sqrt(2.0), 1e-9);
    }
}

TEST(PlateBending, OnlyPlanesCostNothing) {
    for (const LaidOut& mesh : {meshes::grid(9, 9, 0.1), meshes::irregular(9, 9, 0.1, 1),
                                meshes::irregular(9, 9, 0.1, 2, {0.45, 0.5, false})}) {
        const Eigen::MatrixXd matrix = stiffnessMatrix(plateElements(mesh.cloth), mesh.positions.size());
        const Eigen::VectorXd modes = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
        EXPECT_LT(std::abs(modes[0]) + std::abs(modes[2]), 1e-12 * modes.tail(1)[0]);
        // The softest of the others is about the even twist, z = x y.
        double squares = 0;
        for (const Eigen::Vector2d& position : mesh.positions)
            squares += std::pow((position.x() - 0.4) * (position.y() - 0.4), 2);
        const double twist = 2 * meshes::totalArea(mesh.cloth) / squares;
        std::printf("softest mode %.3f of the even twist\n", modes[3] / twist);
        EXPECT_NEAR(modes[3] / twist, 0.9, 0.2);
    }
}

TEST(PlateBending, ACantileverBendsAsABeamInWarpWeftAndBias) {
    for (const auto& strip : {along(40), acrossRows(40)}) {
        EXPECT_NEAR(underOwnWeight(strip), 1, 0.01);
        EXPECT_NEAR(underTipLoad(strip, 0.25), 1, 0.01);
    }
    EXPECT_NEAR(underOwnWeight(bias(40)), 1, 0.02);
    EXPECT_NEAR(underTipLoad(bias(40), 0.25), 1, 0.02);
    std::printf("cantilever, weight and tip load: warp %.4f %.4f weft %.4f %.4f bias %.4f %.4f\n",
                underOwnWeight(along(40)), underTipLoad(along(40), 0.25), underOwnWeight(acrossRows(40)),
                underTipLoad(acrossRows(40), 0.25), underOwnWeight(bias(40)), underTipLoad(bias(40), 0.25));
}

TEST(PlateBending, AFinerCantileverIsBetter) {
    for (const auto& strip : {along, acrossRows}) {
        const double coarse = std::abs(underOwnWeight(strip(20)) - 1);
        const double fine = std::abs(underOwnWeight(strip(40)) - 1);
        std::printf("cantilever error: %.5f, twice as fine %.5f\n", coarse, fine);
        EXPECT_LT(fine, 0.5 * coarse);
    }
}

TEST(PlateBending, AnIrregularCantileverBendsAlmostAsABeam) {
    double mildSum = 0, sum = 0;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const double mildTip = underOwnWeight(irregularStrip(40, seed, mild));
        const double tip = underOwnWeight(irregularStrip(40, seed, Disorder()));
        std::printf("cantilever: mildly irregular %.3f, badly cut %.3f\n", mildTip, tip);
        EXPECT_NEAR(mildTip, 1, 0.06);
        EXPECT_NEAR(tip, 1, 0.12);
        mildSum += mildTip;
        sum += tip;
    }
    EXPECT_NEAR(mildSum / 4, 1, 0.05);
    EXPECT_NEAR(sum / 4, 1, 0.06);
}

TEST(PlateBending, ASquarePlateSagsAsItShould) {
    for (const bool clamped : {true, false}) {
        const double even = plate(meshes::grid(41, 41, 1.0 / 40), 40, clamped);
        const double mildSag = plate(meshes::irregular(41, 41, 1.0 / 40, 1, mild), 40, clamped);
        const double sag = plate(meshes::irregular(41, 41, 1.0 / 40, 1), 40, clamped);
        std::printf("plate %s: grid %.4f, mildly irregular %.3f, badly cut %.3f\n",
                    clamped ? "clamped" : "supported", even, mildSag, sag);
        EXPECT_NEAR(even, 1, 0.01);
        EXPECT_NEAR(mildSag, 1, 0.04);
        EXPECT_NEAR(sag, 1, 0.08);
    }
}

TEST(PlateBending, ASeamIsNoBorder) {
    const LaidOut whole = meshes::irregular(11, 9, 0.02, 3);
    LaidOut cut = whole;
    const Eigen::Rotation2Dd turn(0.9);
    for (auto& corners : cut.cloth.coordinates) {
        const double middle = (corners[0].x() + corners[1].x() + corners[2].x()) / 3;
        if (middle < 0.07) continue;
        for (Eigen::Vector2d& corner : corners) {
            corner = turn * corner + Eigen::Vector2d(1, 2);
            if (middle > 0.13) corner.x() = -corner.x();  // cut from the other face of the cloth
        }
    }
    const auto positions = crumpled(whole, 0.01);
    const auto expected = plateElements(whole.cloth), found = plateElements(cut.cloth);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].nodes, expected[i].nodes);
        EXPECT_NEAR(energy(found[i], positions) / energy(expected[i], positions), 1, 1e-6);
    }
}

TEST(PlateBending, ATubeIsBentAllAround) {
    const int around = 60;
    const LaidOut mesh = meshes::tube(around, 8, 0.01);
    const double radius = mesh.circumference / (360 * degree);
    std::vector<Eigen::Vector3d> positions;
    for (const Eigen::Vector2d& position : mesh.positions)
        positions.emplace_back(radius * std::cos(position.x() / radius),
                               radius * std::sin(position.x() / radius), position.y());
    int inner = 0;
    for (const PlateElement& element : plateElements(mesh.cloth)) {
        if (!isInner(element)) continue;
        ++inner;
        EXPECT_NEAR(energy(element, positions) * radius * radius / (0.5 * element.area), 1, 0.005);
    }
    EXPECT_GT(inner, 10 * around);
}

TEST(PlateBending, WithoutASecondTriangleNothingBends) {
    const ClothMesh single = flatMesh({{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}});
    EXPECT_TRUE(plateElements(single).empty());

    // Three triangles on one edge: none bends there.
    ClothMesh book = flatMesh({{0, 0}, {0, 1}, {1, 0}, {-1, 0}, {1, 1}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
    EXPECT_TRUE(plateElements(book).empty());
}

TEST(PlateBending, TwoTrianglesAreAHinge) {
    // Free on the other edges, the pair may bend as it likes: only a twist of its diagonal is left.
    const ClothMesh pair = flatMesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
    const auto elements = plateElements(pair);
    ASSERT_EQ(elements.size(), 2u);
    EXPECT_NEAR(curvature(elements[0], {0, 1, 0, 1}).squaredNorm(), 8, 1e-9);  // z = x + y - 2 x y
    EXPECT_NEAR(curvature(elements[0], {0, 1, 1, 0}).squaredNorm(), 0, 1e-12);
}

TEST(PlateBending, AFarCornerThatIsThereAlreadyIsCountedOnce) {
    // Around the middle node lie three triangles: across two edges of each, the far corner is the same.
    const LaidOut fan{
        flatMesh({{0, 0}, {1, 0}, {-0.5, 0.8}, {-0.4, -0.9}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}),
        {{0, 0}, {1, 0}, {-0.5, 0.8}, {-0.4, -0.9}}};
    const auto elements = plateElements(fan.cloth);
    ASSERT_EQ(elements.size(), 3u);
    const auto tilted = sampled(fan, [](const Eigen::Vector2d& p) { return 2 + 3 * p.x() - p.y(); });
    for (const PlateElement& element : elements) {
        EXPECT_EQ(std::count(element.nodes.begin(), element.nodes.end(), -1), 2);
        EXPECT_LT(curvature(element, tilted).norm(), 1e-12);
        EXPECT_GT(curvature(element, {0.1, 0, 0, 0}).norm(), 0.1);
        for (std::size_t k = 0; k < 6; ++k) EXPECT_TRUE(element.nodes[k] >= 0 || element.weights[0][k] == 0);
    }

    // A pocket sewn of two triangles: the far corner is the own.
    ClothMesh pocket = flatMesh({{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}, {0, 2, 1}});
    for (const PlateElement& element : plateElements(pocket)) {
        EXPECT_EQ(std::count(element.nodes.begin(), element.nodes.end(), -1), 3);
        EXPECT_LT(curvature(element, {1, 1, 1}).norm(), 1e-12);
    }
}

}  // namespace
}  // namespace drench::plate_bending_test
