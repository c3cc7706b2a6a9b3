// States that a build comes to, as it always has: see tests/golden/README.md.
#include <drench/snapshot.h>
#include <gtest/gtest.h>
#if defined(__GLIBC__)
#include <gnu/libc-version.h>
#endif

#include <LinearMath/btScalar.h>

#include <fstream>
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
};

const std::vector<Golden> goldens = {{"hanging-small-steps", test::hangingInRain, Mover::smallSteps},
                                     {"lying-small-steps", test::lyingOnBall, Mover::smallSteps},
                                     {"two-small-steps", test::twoSheets, Mover::smallSteps},
                                     {"lying-stock", test::lyingOnBall, Mover::stock},
                                     {"two-stock", test::twoSheets, Mover::stock},
                                     {"lying-explicit", test::lyingOnBall, Mover::explicitSteps}};

std::string hashOf(const Golden& golden) {
    const auto scene = golden.build(golden.mover);
    scene->step(100);
    std::ostringstream text;
    text << std::hex;
    for (const Snapshot& snapshot : scene->save()) text << snapshot.hash();
    return text.str();
}

/// All that numbers may depend on but the sources.
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

/// Hash of each scene by build.
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
    if (!toAdd.empty())
        GTEST_SKIP()
            << "This build is not known yet. Where its results are trusted, add to tests/golden/states.txt:\n"
            << toAdd;
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
