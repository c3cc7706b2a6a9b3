#include "run/exporter.h"

#include <drench/files/frame_files.h>

#include <exception>
#include <iostream>
#include <map>

#include "stage/scene_cloth.h"
#include "stage/stage.h"

namespace drench::demo {

const std::vector<std::string>& exportEndings() {
    static const std::vector<std::string> endings = {".glb", ".obj", ".csv"};
    return endings;
}

std::vector<ClothFrame> framesOf(Scene& scene) {
    std::vector<ClothFrame> frames;
    std::map<std::string, int> named;
    for (Stage* stage : scene.stages())
        for (const SceneCloth* sheet : stage->sheets()) {
            const int before = named[sheet->name()]++;
            const std::string number = before > 0 ? ' ' + std::to_string(before + 1) : "";
            frames.push_back(frameOf(sheet->name() + number, sheet->body(), sheet->wet()));
        }
    return frames;
}

Exporter::Exporter(std::filesystem::path file, int every) : file_(std::move(file)), every_(every) {}

void Exporter::add(Scene& scene) {
    ++frames_;
    if (!whole_ || frames_ % every_ != 0) return;
    try {
        keep(scene);
    } catch (const std::exception& problem) {
        lose(problem.what());
    }
}

void Exporter::keep(Scene& scene) {
    const double time = frames_ * Scene::frameTime;
    const std::vector<ClothFrame> sheets = framesOf(scene);
    if (file_.extension() == ".glb")
        animation_.add(time, sheets);
    else if (file_.extension() == ".obj")
        writeObj(numbered(file_, frames_ / every_), sheets);
    else
        writeCsv(numbered(file_, frames_ / every_), time, sheets);
}

bool Exporter::finish() {
    if (animation_.size() == 0) return whole_;
    try {
        animation_.write(file_);
    } catch (const std::exception& problem) {
        lose(problem.what());
    }
    return whole_;
}

void Exporter::lose(const std::string& why) {
    whole_ = false;
    std::cerr << "drench-demo: " << why << std::endl;
}

}  // namespace drench::demo
