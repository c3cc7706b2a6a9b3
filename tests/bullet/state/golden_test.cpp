// States that a build comes to, as it always has: see tests/golden/README.md.
#include <drench/snapshot.h>
#include <gtest/gtest.h>
#if defined(__GLIBC__)
#include <gnu/libc-version.h>
#endif

#include <LinearMath/btScalar.h>

#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "snapshot_rig.h"

namespace drench::golden_test {
namespace {

using test::Mover;

struct Golden {
    const char* name;
    std::unique_ptr<test::WetScene> (*build)(Mover);
    Mover mover;
    double water, height;  // kg, and the mean of all nodes, m, that any build comes to
};

const std::vector<Golden> goldens = {
    {"hanging-small-steps", test::hangingInRain, Mover::smallSteps, 0.043196, -0.164377},
    {"lying-small-steps", test::lyingOnBall, Mover::smallSteps, 0.037511, -0.092250},
    {"two-small-steps", test::twoSheets, Mover::smallSteps, 0.017998, -0.000998},
    {"lying-stock", test::lyingOnBall, Mover::stock, 0.030161, -0.095979},
    {"two-stock", test::twoSheets, Mover::stock, 0.018000, -0.002031},
    {"lying-explicit", test::lyingOnBall, Mover::explicitSteps, 0.028078, -0.010598}};

std::unique_ptr<test::WetScene> sceneOf(const Golden& golden) {
    auto scene = golden.build(golden.mover);
    scene->step(100);
    return scene;
}

std::string hashOf(const test::WetScene& scene) {
    std::ostringstream text;
    text << std::hex;
    for (const Snapshot& snapshot : scene.save()) text << snapshot.hash();
    return text.str();
}

std::string hashOf(const Golden& golden) {
    return hashOf(*sceneOf(golden));
}

double heightOf(test::WetScene& scene) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < scene.size(); ++i) {
        const auto& nodes = scene.sheet(i).m_nodes;
        for (int n = 0; n < nodes.size(); ++n) sum += double(nodes[n].m_x.y());
        count += nodes.size();
    }
    return sum / count;
}

double waterOf(test::WetScene& scene) {
    double sum = 0;
    for (std::size_t i = 0; i < scene.size(); ++i) sum += scene.cloth(i).waterMass();
    return sum;
}

// All that numbers may depend on but the sources.
std::string buildKey() {
    std::ostringstream key;
#if defined(__clang__)
    key << "clang " << __clang_version__;
#elif defined(__GNUC__)
    key << "gcc " << __VERSION__;
#else
    key << "another compiler";
#endif
    key << (sizeof(btScalar) == 4 ? ", single, " : ", double, ") << DRENCH_BUILD_FLAGS << ", "
        << SmallStepSolver().kernels() << ", Bullet " << btGetVersion() << ", Eigen " << EIGEN_WORLD_VERSION
        << '.' << EIGEN_MAJOR_VERSION << '.' << EIGEN_MINOR_VERSION;
#if defined(__GLIBC__)
    key << ", glibc " << gnu_get_libc_version();
#endif
#if defined(__x86_64__) && defined(__GNUC__)
    key << (__builtin_cpu_supports("fma") ? ", fma" : ", no fma");  // by which glibc chooses its functions
#endif
    return key.str();
}

// Hash of each scene by build.
std::map<std::string, std::string> knownHashes(const std::string& key) {
    std::ifstream file(DRENCH_SOURCE_DIR "/tests/golden/states.txt");
    std::map<std::string, std::string> hashes;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string name, hash, rest;
        words >> name >> hash >> std::ws;
        std::getline(words, rest);
        if (rest == key) hashes[name] = hash;
    }
    return hashes;
}

// Whether this is a build as tests/run.sh makes them on Debian 12, on a processor with AVX2 and FMA. All of these are known.
bool isOneOfOurs() {
#if defined(__x86_64__) && defined(__GNUC__) && __GNUC__ == 12 && !defined(__clang__)
    std::ifstream file("/etc/os-release");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const bool isDebian12 = text.find("\nID=debian\n") != std::string::npos &&
                            text.find("\nVERSION_ID=\"12\"\n") != std::string::npos;
    const bool hasAvx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    return isDebian12 && hasAvx2 && std::string(DRENCH_BUILD_FLAGS) == "Release";
#else
    return false;
#endif
}

TEST(Golden, OutcomesAreThoseOfAnyBuild) {
    for (const Golden& golden : goldens) {
        const auto scene = sceneOf(golden);
        EXPECT_NEAR(waterOf(*scene), golden.water, 1e-3 * golden.water) << golden.name;
        EXPECT_NEAR(heightOf(*scene), golden.height, 5e-4) << golden.name;
    }
}

TEST(Golden, StatesAreWhatTheyHaveBeen) {
    const std::string key = buildKey();
    const auto known = knownHashes(key);
    std::string toAdd;
    for (const Golden& golden : goldens) {
        const std::string hash = hashOf(golden);
        const auto found = known.find(golden.name);
        if (found == known.end())
            toAdd += golden.name + (" " + hash) + " " + key + "\n";
        else
            EXPECT_EQ(hash, found->second)
                << golden.name << "; if the change is meant, see tests/golden/README.md";
    }
    if (toAdd.empty()) return;
    const std::string unknown =
        "This build is not known: " + key +
        "\nWhere its results are trusted, add to tests/golden/states.txt (see README.md beside it):\n" +
        toAdd;
    if (isOneOfOurs()) FAIL() << unknown;
    GTEST_SKIP() << unknown;
}

TEST(Golden, AnyNumberOfThreadsComesToTheSame) {
    std::vector<std::string> alone;
    for (const Golden& golden : goldens) alone.push_back(hashOf(golden));
    for (const std::size_t count : {2u, 4u}) {
        std::vector<std::string> together(goldens.size());
        std::vector<std::thread> threads;
        for (std::size_t thread = 0; thread < count; ++thread)
            threads.emplace_back([&, thread] {
                for (std::size_t i = thread; i < goldens.size(); i += count) together[i] = hashOf(goldens[i]);
            });
        for (std::thread& thread : threads) thread.join();
        EXPECT_EQ(together, alone) << count << " threads";
    }
}

}  // namespace
}  // namespace drench::golden_test
