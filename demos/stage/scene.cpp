#include "stage/scene.h"

#include "stage/stage.h"

namespace drench::demo {

std::vector<SceneSheet> Scene::sheets() {
    std::vector<SceneSheet> list;
    for (Stage* stage : stages())
        for (SceneCloth* sheet : stage->sheets()) list.push_back({sheet->name(), &sheet->wet()});
    return list;
}

}  // namespace drench::demo
