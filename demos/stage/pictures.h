// Sheets as the viewer wants them.
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

// What a picture shows of its wet sheets.
enum class View {
    beauty,   // how they look
    content,  // water over dry cloth, kg/kg
    film,     // thickness of the film on one face, micrometres
    strain    // of stretch and shear, mean of the links at a node, %
};

// A wet sheet as it is now: where it is, how its water makes it look, and its values in the view.
viewer::SheetMesh sheetMesh(const btSoftBody& body, const WetCloth& cloth, View view = View::beauty);

// What each node has of the quantity of a view; empty for `View::beauty`.
std::vector<float> values(const btSoftBody& body, const WetCloth& cloth, View view);

// What the colours of a view of these cloths mean: from 0 to the content of full pores of the most absorbent fabric, 200
// micrometres, or 5 %. None for `View::beauty`.
std::optional<viewer::Legend> legend(View view, const std::vector<const WetCloth*>& cloths);

// A sheet without water as it is now, all of one colour.
viewer::SheetMesh sheetMesh(const btSoftBody& body, const Eigen::Vector3f& albedo);

}  // namespace drench::demo
