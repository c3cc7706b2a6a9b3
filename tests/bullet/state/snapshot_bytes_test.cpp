// A snapshot that tests/tools/write_snapshot_bytes.cpp made long ago, read by Drench and, independently, byte by byte as docs/snapshots.md says.
#include <drench/snapshot.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "snapshot_rig.h"

namespace drench::snapshot_bytes_test {
namespace {

const std::string path = DRENCH_SOURCE_DIR "/tests/bullet/state/data/small.snapshot";

// Makes numbers of bytes by arithmetic alone, so that it reads the same on a machine of any byte order.
class Decoder {
  public:
    explicit Decoder(std::string bytes) : bytes_(std::move(bytes)) {}

    std::uint64_t whole(int size) {
        std::uint64_t number = 0, weight = 1;
        for (int i = 0; i < size; ++i, weight *= 256)
            number += weight * static_cast<unsigned char>(bytes_.at(at_++));
        return number;
    }
    double real(int size) {
        const int mantissaBits = size == 4 ? 23 : 52, exponentBits = size == 4 ? 8 : 11;
        const std::uint64_t bits = whole(size);
        const auto exponent = static_cast<int>(bits >> mantissaBits & ((1u << exponentBits) - 1));
        const int bias = (1 << (exponentBits - 1)) - 1;
        const double fraction =
            std::ldexp(double(bits & ((std::uint64_t{1} << mantissaBits) - 1)), -mantissaBits);
        const double size1 =
            exponent == 0 ? std::ldexp(fraction, 1 - bias) : std::ldexp(1 + fraction, exponent - bias);
        return bits >> (8 * size - 1) ? -size1 : size1;
    }
    std::string text() {
        const auto size = static_cast<std::size_t>(whole(8));
        at_ += size;
        return bytes_.substr(at_ - size, size);
    }
    std::string letters(std::size_t count) {
        at_ += count;
        return bytes_.substr(at_ - count, count);
    }
    std::size_t left() const { return bytes_.size() - at_; }

  private:
    std::string bytes_;
    std::size_t at_ = 0;
};

std::string contents() {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// What stands before the sections, checked, and then those by name.
std::map<std::string, std::string> sections() {
    Decoder file(contents());
    EXPECT_EQ(file.letters(8),
              "\x89"
              "DRNCH\r\n");
    EXPECT_EQ(file.whole(4), 1u) << "format";
    EXPECT_EQ(file.whole(4), 4u) << "precision";
    EXPECT_EQ(file.whole(8), contents().size());
    EXPECT_EQ(file.text(), "0.1.0");
    for (const std::uint64_t count : {9u, 26u, 8u})
        EXPECT_EQ(file.whole(8), count) << "nodes, links or faces";
    file.whole(8);
    std::map<std::string, std::string> all;
    while (file.left() > 8) {
        const std::string name = file.letters(4);
        all[name] = file.text();
    }
    return all;
}

// The fabric that the file names, whatever has become of cotton since.
Fabric fabricOfFile() {
    Decoder cloth(sections().at("CLTH"));
    Fabric fabric;
    fabric.name = cloth.text();
    const std::uint64_t count = cloth.whole(8);
    EXPECT_EQ(count, 34u) << "of format 1";
    for (std::uint64_t i = 0; i < count; ++i)
        fabric.*fabricParameters()[static_cast<std::size_t>(i)].member = cloth.real(8);
    return fabric;
}

TEST(SnapshotBytes, AreReadAsEver) {
    const auto parts = sections();
    ASSERT_EQ(parts.size(), 8u);
    Decoder body(parts.at("BODY")), water(parts.at("WATR")), moment(parts.at("TIME"));
    EXPECT_EQ(body.whole(1), 0u) << "not of a deformable world";
    EXPECT_NEAR(body.real(4), -0.1, 1e-6) << "x of the first node, a pin";
    EXPECT_NEAR(moment.real(8), 40.0 / 60, 1e-6) << "time";
    double pores = 0;
    for (int n = 0; n < 9; ++n) pores += water.real(8);
    EXPECT_NEAR(pores, 0.04 * 0.219 * -std::expm1(-(40.0 / 60) / 2), 1e-5)
        << "kg, of 219 g/m2 after 2/3 s of 2 s";
}

TEST(SnapshotBytes, AreRestoredAsEver) {
    const auto scene = test::smallestScene(fabricOfFile());
    const Snapshot old = readSnapshot(path);
    if (sizeof(btScalar) != 4) {
        const auto before = scene->cloth().snapshot().hash();
        EXPECT_THROW(scene->cloth().restore(old), std::runtime_error) << "of single precision";
        EXPECT_EQ(scene->cloth().snapshot().hash(), before);
        return;
    }
    scene->cloth().restore(old);
    EXPECT_EQ(scene->cloth().snapshot().hash(), old.hash());
    Decoder body(sections().at("BODY"));
    body.whole(1);
    for (int n = 0; n < 9; ++n) {
        const btSoftBody::Node& node = scene->sheet().m_nodes[n];
        for (const btVector3* vector : {&node.m_x, &node.m_q, &node.m_v, &node.m_f, &node.m_n})
            for (const btScalar component : {vector->x(), vector->y(), vector->z()})
                EXPECT_EQ(body.real(4), double(component)) << n;
        EXPECT_EQ(body.real(4), double(node.m_im)) << n;
    }
    scene->step(5);
    EXPECT_TRUE(test::isFinite(scene->sheet()));
}

}  // namespace
}  // namespace drench::snapshot_bytes_test
