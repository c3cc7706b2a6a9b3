// Functions that make the built-in scenes; each is in the file of its name.
#pragma once

#include <memory>

#include "stage/scene.h"

namespace drench::demo {

using SceneMaker = std::unique_ptr<Scene>(const SceneOptions&);

SceneMaker makeCling, makeClothesline, makeDip, makeDrape, makeDrapeMeter, makeFlag, makeFold,
    makeHalfUnderRoof, makeHeap, makeSlide, makeSpill, makeStockAndDrench, makeTenSteps, makeWick, makeWring;

}  // namespace drench::demo
