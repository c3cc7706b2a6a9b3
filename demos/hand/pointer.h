// What the user's mouse does to a scene.
#pragma once

#include <Eigen/Core>

#include "viewer/picture/picking.h"

namespace drench::demo {

// What the left button does to cloth.
enum class Tool {
    hand,  // holds it and drags it along
    hose,  // sprays water at it
    towel  // dabs it dry
};

// The mouse over the picture.
struct Pointer {
    bool pressed = false;  // the left button, on cloth or with a tool other than the hand
    Tool tool = Tool::hand;
    bool onTwin = false;                                  // over the dry twin of the scene
    viewer::Ray ray;                                      // from the eye through the pointer, m
    Eigen::Vector3f forward = -Eigen::Vector3f::UnitZ();  // of the camera, unit length
};

}  // namespace drench::demo
