#include "run/exporter.h"

#include <drench/files/frame_files.h>

#include <exception>
#include <iostream>
#include <map>

#include "run/run_options.h"
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

template <typename Work>
void FrameKeeper::attempt(Work work) {
    try {
        work();
    } catch (const std::exception& problem) {
        whole_ = false;
        std::cerr << "drench-demo: " << problem.what() << std::endl;
    }
}

void FrameKeeper::add(Scene& scene) {
    ++frames_;
    if (whole_ && isDue()) attempt([&] { keep(scene); });
}

bool FrameKeeper::finish() {
    attempt([&] { complete(); });
    return whole_;
}

void Exporter::keep(Scene& scene) {
    const double time = frames() * Scene::frameTime;
    const std::vector<ClothFrame> sheets = framesOf(scene);
    if (file_.extension() == ".glb")
        animation_.add(time, sheets);
    else if (file_.extension() == ".obj")
        writeObj(numbered(file_, frames() / every()), sheets);
    else
        writeCsv(numbered(file_, frames() / every()), time, sheets);
}

void Exporter::complete() {
    if (animation_.size() > 0) animation_.write(file_);
}

Film::Film(const std::filesystem::path& file, int every, View view)
    : FrameKeeper(every),
      view_(view),
      recorder_(file, pictureWidth, pictureHeight, 1 / (every * Scene::frameTime)) {}

void Film::keep(Scene& scene) {
    context_.makeCurrent();
    recorder_.add(renderer_.capture(scene.picture(view_), pictureWidth, pictureHeight));
}

void Film::complete() {
    if (isWhole()) recorder_.finish();
}

}  // namespace drench::demo
