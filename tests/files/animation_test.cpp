// Animated glTF, read back by readers that did not write it.
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <drench/files/animation.h>
#include <gtest/gtest.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "glb_reader.h"
#include "temporary_folder.h"
#include "wet_run.h"

namespace drench::animation_test {
namespace {

using test::GlbReader;
using test::refusal;
using test::TemporaryFolder;

constexpr double frameTime = 1.0 / 60;

Animation recorded(const std::vector<std::vector<ClothFrame>>& run) {
    Animation animation;
    for (std::size_t i = 0; i < run.size(); ++i) animation.add(3 + double(i) * frameTime, run[i]);
    return animation;
}

const aiMeshMorphAnim& channelOf(const aiAnimation& animation, const std::string& node) {
    for (unsigned i = 0; i < animation.mNumMorphMeshChannels; ++i)
        if (animation.mMorphMeshChannels[i]->mName.C_Str() == node) return *animation.mMorphMeshChannels[i];
    throw std::runtime_error("no channel for " + node);
}

const aiMesh& meshOf(const aiScene& scene, const std::string& name) {
    for (unsigned i = 0; i < scene.mNumMeshes; ++i)
        if (std::string(scene.mMeshes[i]->mName.C_Str()).find(name) != std::string::npos)
            return *scene.mMeshes[i];
    throw std::runtime_error("no mesh " + name);
}

using Positions = std::vector<Eigen::Vector3f>;

Eigen::Vector3f toEigen(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

// Where the vertices of a mesh, or their normals, are at a key of the animation: those of the mesh, and of each
// target, by its weight, what it changes.
Positions played(const aiMesh& mesh, const aiMeshMorphKey& key, bool normals) {
    const auto vectors = [&](const auto& of) { return normals ? of.mNormals : of.mVertices; };
    Positions positions;
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        const Eigen::Vector3f base = toEigen(vectors(mesh)[v]);
        Eigen::Vector3f position = base;
        for (unsigned i = 0; i < key.mNumValuesAndWeights; ++i)
            position +=
                float(key.mWeights[i]) * (toEigen(vectors(*mesh.mAnimMeshes[key.mValues[i]])[v]) - base);
        positions.push_back(position);
    }
    return positions;
}

void expectSame(const Positions& a, const Positions& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT((a[i] - b[i]).norm(), 1e-6f) << i;
}

TEST(Animation, PlaysWhatWasRecordedInAssimp) {
    const TemporaryFolder folder;
    const auto run = test::wetRun(7);
    recorded(run).write(folder / "run.glb");

    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile((folder / "run.glb").string(), 0);
    ASSERT_TRUE(scene) << importer.GetErrorString();
    ASSERT_EQ(scene->mNumAnimations, 1u);
    const aiAnimation& animation = *scene->mAnimations[0];
    for (std::size_t s = 0; s < 2; ++s) {
        const std::string name = run[0][s].name;
        const aiMesh& mesh = meshOf(*scene, name);
        const aiMeshMorphAnim& channel = channelOf(animation, name);
        ASSERT_EQ(mesh.mNumFaces, run[0][s].triangles.size());
        for (unsigned f = 0; f < mesh.mNumFaces; ++f)
            for (unsigned k = 0; k < 3; ++k)
                ASSERT_EQ(int(mesh.mFaces[f].mIndices[k]), run[0][s].triangles[f][k]);
        ASSERT_EQ(channel.mNumKeys, run.size());
        for (unsigned frame = 0; frame < channel.mNumKeys; ++frame) {
            const aiMeshMorphKey& key = channel.mKeys[frame];
            EXPECT_NEAR(key.mTime / animation.mTicksPerSecond, frame * frameTime, 1e-6);
            expectSame(played(mesh, key, false), run[frame][s].positions);
            expectSame(played(mesh, key, true), run[frame][s].normals);
        }
    }
    EXPECT_GT((run[6][0].positions[80] - run[0][0].positions[80]).norm(), 0.01f);  // something has moved
}

TEST(Animation, ColoursAndWetnessFollowTheWater) {
    const TemporaryFolder folder;
    const auto run = test::wetRun(5);
    recorded(run).write(folder / "run.glb");
    const GlbReader file(test::contentsOf(folder / "run.glb"));
    for (std::size_t s = 0; s < 2; ++s)
        for (std::size_t frame = 0; frame < run.size(); ++frame) {
            const std::vector<float> wetness = file.attribute(s, "_WETNESS", frame);
            const std::vector<float> colours = file.attribute(s, "COLOR_0", frame);
            for (std::size_t node = 0; node < wetness.size(); ++node) {
                EXPECT_NEAR(wetness[node], run[frame][s].saturations[node], 1e-6);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(colours[3 * node + std::size_t(c)], run[frame][s].colours[node][c], 1e-6);
            }
        }
    EXPECT_GT(file.attribute(0, "_WETNESS", 4)[20], 0.03f);
    EXPECT_LT(file.attribute(0, "COLOR_0", 4)[60], file.attribute(0, "COLOR_0", 0)[60]);
}

TEST(Animation, WhatDoesNotChangeIsThereOnce) {
    auto still = test::wetRun(1);
    still.resize(6, still[0]);
    const TemporaryFolder folder;
    const Animation animation = recorded(still);
    const std::size_t nodes = 2 * 81;
    EXPECT_EQ(animation.bytes(), 40 * nodes + 4 * 36);
    animation.write(folder / "still.glb");
    // The base, one change that is none, the triangles, and the weights and times of 6 frames.
    EXPECT_LT(test::contentsOf(folder / "still.glb").size(), 80 * nodes + 2 * 12 * 128 + 4 * 36 + 6000);
}

TEST(Animation, TwoFramesMoveAndOneStandsStill) {
    const TemporaryFolder folder;
    const auto run = test::wetRun(2);
    recorded(run).write(folder / "two.glb");
    recorded({run[0]}).write(folder / "one.glb");
    const GlbReader two(test::contentsOf(folder / "two.glb")), one(test::contentsOf(folder / "one.glb"));
    EXPECT_EQ(two.json()["animations"][0]["channels"].size(), 2u);
    EXPECT_FALSE(one.json().contains("animations"));
    EXPECT_EQ(one.attribute(0, "POSITION", 0), two.attribute(0, "POSITION", 0));
}

TEST(Animation, SameFramesSameBytes) {
    const TemporaryFolder folder;
    const auto run = test::wetRun(3);
    recorded(run).write(folder / "a.glb");
    recorded(run).write(folder / "b.glb");
    EXPECT_EQ(test::contentsOf(folder / "a.glb"), test::contentsOf(folder / "b.glb"));
    EXPECT_EQ(folder.files(), 2u);
}

TEST(Animation, KhronosValidatorFindsNothing) {
    const char* validator = std::getenv("DRENCH_GLTF_VALIDATOR");
    if (!validator || std::system("node --version > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "set DRENCH_GLTF_VALIDATOR to a folder in which npm has installed gltf-validator";
    const TemporaryFolder folder;
    const auto run = test::wetRun(5);
    recorded(run).write(folder / "run.glb");
    recorded({run[0]}).write(folder / "still.glb");
    for (const char* name : {"run.glb", "still.glb"}) {
        const std::string command = "NODE_PATH='" + std::string(validator) + "/node_modules' node '" +
                                    DRENCH_SOURCE_DIR "/tests/files/validate_glb.js' '" +
                                    (folder / name).string() + "'";
        EXPECT_EQ(std::system(command.c_str()), 0) << name;
    }
}

TEST(Animation, RefusesFramesThatDoNotFit) {
    const auto run = test::wetRun(2);
    Animation animation;
    EXPECT_NE(refusal<std::logic_error>([&] { animation.write("nothing.glb"); }), "");
    animation.add(0, run[0]);
    const auto refused = [&](double time, std::vector<ClothFrame> frame) {
        return refusal<std::invalid_argument>([&] { animation.add(time, frame); });
    };
    EXPECT_NE(refused(0, run[1]).find("later"), std::string::npos);
    EXPECT_NE(refused(std::nan(""), run[1]).find("NaN"), std::string::npos);
    EXPECT_NE(refused(1, {}).find("no sheets"), std::string::npos);
    EXPECT_NE(refused(1, {run[1][0]}).find("1 sheets"), std::string::npos);
    EXPECT_NE(refused(1, {run[1][1], run[1][0]}).find("same order"), std::string::npos);
    EXPECT_NE(refused(1, {run[1][0], run[1][0]}).find("two sheets"), std::string::npos);
    auto torn = run[1];
    std::swap(torn[0].triangles[0], torn[0].triangles[1]);
    EXPECT_NE(refused(1, torn).find("other nodes or triangles"), std::string::npos);
    auto broken = run[1];
    broken[1].positions[3].x() = std::numeric_limits<float>::infinity();
    EXPECT_NE(refused(1, broken).find("sheet 'wool': positions of node 3"), std::string::npos);
    EXPECT_EQ(animation.size(), 1u);
    animation.add(1, run[1]);
    EXPECT_EQ(animation.size(), 2u);
}

TEST(Animation, StaysWithinItsBytes) {
    const auto run = test::wetRun(4);
    EXPECT_THROW(Animation(0), std::invalid_argument);
    EXPECT_THROW(Animation(2'000'000'001), std::invalid_argument);
    Animation animation(3 * 162 * 40);  // three frames, but for their weights
    animation.add(0, run[0]);
    animation.add(1, run[1]);
    const std::string why = refusal<std::length_error>([&] { animation.add(2, run[2]); });
    EXPECT_NE(why.find("2 frames are all that fit"), std::string::npos) << why;
    EXPECT_EQ(animation.size(), 2u);
}

TEST(Animation, NothingStandsUnderTheNameUntilItIsWhole) {
    const TemporaryFolder folder;
    const Animation animation = recorded(test::wetRun(1));
    test::put(folder / "taken", "");
    EXPECT_NE(refusal<std::runtime_error>([&] { animation.write(folder / "taken" / "run.glb"); }), "");
    std::filesystem::create_directory(folder / "folder.glb");
    EXPECT_NE(refusal<std::runtime_error>([&] { animation.write(folder / "folder.glb"); }).find("folder.glb"),
              std::string::npos);
    EXPECT_EQ(folder.files(), 2u);
}

}  // namespace
}  // namespace drench::animation_test
