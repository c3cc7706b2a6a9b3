// State of the mouse over a scene.
#pragma once

#include <Eigen/Core>

#include "viewer/picture/picking.h"

namespace drench::demo {

// Action of the left button on cloth.
enum class Tool {
    hand,  // drags it
    hose,  // sprays water on it
    towel  // dabs it dry
};

// The mouse over the picture.
struct Pointer {
    bool pressed = false;  // the left button, on cloth or with a tool other than the hand
    Tool tool = Tool::hand;
    bool onTwin = false;                                  // over the dry twin of the scene
    viewer::Ray ray;                                      // from the eye through the pointer, m
    Eigen::Vector3f forward = -Eigen::Vector3f::UnitZ();  // direction of view, unit length
};

}  // namespace drench::demo
