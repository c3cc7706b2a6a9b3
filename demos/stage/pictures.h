// Converts sheets for the viewer.
#pragma once

#include <drench/config.h>

#include <optional>
#include <vector>

#include "viewer/picture/picture.h"

class btSoftBody;

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {
class WetCloth;
}
}  // namespace drench

namespace drench::demo {

// The quantity that pictures show on wet sheets.
enum class View {
    beauty,   // appearance
    content,  // moisture content, kg/kg
    film,     // thickness of the film on one face, micrometres
    strain    // mean |strain| of the stretch and shear links at a node, %
};

// A wet sheet in its present state: positions, appearance and the values of the view.
viewer::SheetMesh sheetMesh(const btSoftBody& body, const WetCloth& cloth, View view = View::beauty);

// Value of each node in a view; empty for `View::beauty`.
std::vector<float> values(const btSoftBody& body, const WetCloth& cloth, View view);

// The legend of a view of these sheets: from 0 to the moisture content of full pores of the most absorbent
// fabric, 200 micrometres, or 5 %. None for `View::beauty`.
std::optional<viewer::Legend> legend(View view, const std::vector<const WetCloth*>& cloths);

// A sheet without water in its present state, in a single colour.
viewer::SheetMesh sheetMesh(const btSoftBody& body, const Eigen::Vector3f& albedo);

}  // namespace drench::demo
