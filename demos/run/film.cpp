#include "run/film.h"

#include <exception>
#include <iostream>

#include "run/picture_size.h"
#include "stage/scene.h"

namespace drench::demo {

Film::Film(const std::filesystem::path& file, int every)
    : every_(every), recorder_(file, pictureWidth, pictureHeight, 1 / (every * Scene::frameTime)) {}

void Film::add(const viewer::Picture& picture) {
    if (!whole_ || frames_++ % every_ != 0) return;
    context_.makeCurrent();
    try {
        recorder_.add(renderer_.capture(picture, pictureWidth, pictureHeight));
    } catch (const std::exception& problem) {
        lose(problem.what());
    }
}

bool Film::finish() {
    if (!whole_) return false;
    try {
        recorder_.finish();
    } catch (const std::exception& problem) {
        lose(problem.what());
    }
    return whole_;
}

void Film::lose(const std::string& why) {
    whole_ = false;
    std::cerr << "drench-demo: " << why << std::endl;
}

}  // namespace drench::demo
