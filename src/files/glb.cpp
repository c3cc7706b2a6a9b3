#include "files/json.h"

// Compiled into this library under names of its own, because an application may have another build of tinygltf, and
// without reading and writing of pictures, which needs stb.
#define tinygltf drench_tinygltf
#define dlib drench_dlib
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "checks/checks.h"
#include "files/recording.h"

namespace drench::files {

namespace {

using tinygltf::Model;

template <typename List>
int last(const List& list) {
    return static_cast<int>(list.size()) - 1;
}

// Appends arrays to the only buffer of the file.
class Buffer {
  public:
    explicit Buffer(Model& model) : model_(model) { model.buffers.emplace_back(); }

    // Begins a view: a part of the buffer that accessors share.
    // @param target  its use: a constant of tinygltf, or 0
    // @param stride  bytes from one element to the next; 0: tightly packed
    void beginView(int target, std::size_t stride) {
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = bytes().size();
        view.target = target;
        view.byteStride = stride;
        model_.bufferViews.push_back(view);
    }

    // Adds an array to the current view. @return its accessor
    template <typename Number>
    int add(const std::vector<Number>& numbers, int components, int componentType, bool withRange) {
        tinygltf::BufferView& view = model_.bufferViews.back();
        tinygltf::Accessor accessor;
        accessor.bufferView = last(model_.bufferViews);
        accessor.byteOffset = view.byteLength;
        accessor.componentType = componentType;
        accessor.type = components == 1 ? TINYGLTF_TYPE_SCALAR : TINYGLTF_TYPE_VEC3;
        accessor.count = numbers.size() / static_cast<std::size_t>(components);
        if (withRange) setRange(accessor, numbers, static_cast<std::size_t>(components));
        const auto* from = reinterpret_cast<const unsigned char*>(numbers.data());
        bytes().insert(bytes().end(), from, from + numbers.size() * sizeof(Number));
        view.byteLength += numbers.size() * sizeof(Number);
        model_.accessors.push_back(std::move(accessor));
        return last(model_.accessors);
    }

  private:
    std::vector<unsigned char>& bytes() { return model_.buffers[0].data; }

    template <typename Number>
    static void setRange(tinygltf::Accessor& accessor, const std::vector<Number>& numbers,
                         std::size_t components) {
        for (std::size_t c = 0; c < components; ++c) {
            Number min = numbers[c], max = numbers[c];
            for (std::size_t i = c; i < numbers.size(); i += components) {
                min = std::min(min, numbers[i]);
                max = std::max(max, numbers[i]);
            }
            accessor.minValues.push_back(double(min));
            accessor.maxValues.push_back(double(max));
        }
    }

    Model& model_;
};

// Writes one attribute: its values in the first frame, and the changes in each further frame.
void addAttribute(Buffer& buffer, tinygltf::Primitive& primitive, const char* name, const Track& track) {
    const bool withRange = std::string(name) == "POSITION";
    const auto add = [&](const std::vector<float>& values) {
        return buffer.add(values, track.components, TINYGLTF_COMPONENT_TYPE_FLOAT, withRange);
    };
    buffer.beginView(TINYGLTF_TARGET_ARRAY_BUFFER,
                     sizeof(float) * static_cast<std::size_t>(track.components));
    const std::vector<float>& base = track.blocks.front();
    primitive.attributes[name] = add(base);
    std::vector<int> accessorOfBlock(track.blocks.size(), -1);
    for (std::size_t frame = 1; frame < track.blockOfFrame.size(); ++frame) {
        const std::size_t block = track.blockOfFrame[frame];
        if (accessorOfBlock[block] < 0) {
            std::vector<float> change = track.blocks[block];
            for (std::size_t i = 0; i < change.size(); ++i) change[i] -= base[i];
            accessorOfBlock[block] = add(change);
        }
        primitive.targets[frame - 1][name] = accessorOfBlock[block];
    }
}

int addIndices(Buffer& buffer, const RecordedSheet& sheet) {
    std::vector<std::uint32_t> indices;
    for (const auto& triangle : sheet.triangles)
        for (const int node : triangle) indices.push_back(static_cast<std::uint32_t>(node));
    buffer.beginView(TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, 0);
    return buffer.add(indices, 1, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, false);
}

int addMaterial(Model& model, const RecordedSheet& sheet, std::size_t frames) {
    constexpr double dryRoughness = 0.9, wetRoughness = 0.3;
    const double gloss = sheet.glossSum / double(frames);
    tinygltf::Material material;
    material.name = sheet.name;
    material.doubleSided = true;
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = dryRoughness + gloss * (wetRoughness - dryRoughness);
    model.materials.push_back(std::move(material));
    return last(model.materials);
}

// @return index of the node
int addSheet(Model& model, Buffer& buffer, const RecordedSheet& sheet, std::size_t frames) {
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.targets.resize(frames - 1);
    primitive.indices = addIndices(buffer, sheet);
    primitive.material = addMaterial(model, sheet, frames);
    addAttribute(buffer, primitive, "POSITION", sheet.positions);
    addAttribute(buffer, primitive, "NORMAL", sheet.normals);
    addAttribute(buffer, primitive, "COLOR_0", sheet.colours);
    addAttribute(buffer, primitive, "_WETNESS", sheet.wetness);
    tinygltf::Mesh mesh;
    mesh.name = sheet.name;
    mesh.primitives.push_back(std::move(primitive));
    model.meshes.push_back(std::move(mesh));
    tinygltf::Node node;
    node.name = sheet.name;
    node.mesh = last(model.meshes);
    model.nodes.push_back(node);
    return last(model.nodes);
}

// At the time of a frame the weight of its own morph target is 1; at the time of the first frame all are 0.
std::vector<float> weightsOf(std::size_t frames) {
    const std::size_t targets = frames - 1;
    std::vector<float> weights(frames * targets, 0.f);
    for (std::size_t frame = 1; frame < frames; ++frame) weights[frame * targets + frame - 1] = 1;
    return weights;
}

void addAnimation(Model& model, Buffer& buffer, const RecordedRun& run) {
    tinygltf::AnimationSampler sampler;
    sampler.interpolation = "LINEAR";
    buffer.beginView(0, 0);
    const std::vector<float> times(run.times.begin(), run.times.end());
    sampler.input = buffer.add(times, 1, TINYGLTF_COMPONENT_TYPE_FLOAT, true);
    buffer.beginView(0, 0);
    sampler.output = buffer.add(weightsOf(times.size()), 1, TINYGLTF_COMPONENT_TYPE_FLOAT, false);
    tinygltf::Animation animation;
    animation.name = "run";
    animation.samplers.push_back(sampler);
    for (const int node : model.scenes[0].nodes) {
        tinygltf::AnimationChannel channel;
        channel.sampler = 0;
        channel.target_node = node;
        channel.target_path = "weights";
        animation.channels.push_back(channel);
    }
    model.animations.push_back(std::move(animation));
}

}  // namespace

std::string glbOf(const RecordedRun& run) {
    Model model;
    model.asset.version = "2.0";
    model.asset.generator = "Drench";
    model.defaultScene = 0;
    model.scenes.emplace_back();
    Buffer buffer(model);
    for (const RecordedSheet& sheet : run.sheets)
        model.scenes[0].nodes.push_back(addSheet(model, buffer, sheet, run.times.size()));
    if (run.times.size() > 1) addAnimation(model, buffer, run);
    std::ostringstream stream;
    constexpr bool pretty = false, binary = true;
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, pretty, binary))
        refuse<std::runtime_error>("tinygltf cannot write the animation");
    return stream.str();
}

}  // namespace drench::files
