// How stiffly the plates of a sheet respond to their own moments, and what a few bad triangles may do to that.
#pragma once

#include <vector>

#include "cloth/plate_bending.h"

namespace drench {

// Response of the curvature of a plate to its own moment, times areal density, 1/m4: a value that plates on nine
// tenths of the area do not exceed. It determines the longest step in which cloth has its bending rigidity.
//
// The height of a neighbour is in the denominator, so next to a sliver a plate of any size responds as strongly
// as the sliver. It is therefore counted as if its neighbours were of its own size: as at most a multiple of the
// inverse fourth power of its own smallest height.
double usualResponse(const std::vector<PlateElement>& plates, const ClothMesh& mesh);

// Reduces weights, such that no combination of components of the curvature has a larger response than `max`;
// other combinations keep theirs. A plate at a sliver then bends easily across it, rather than not at all, and
// keeps its stiffness otherwise.
void limitResponses(std::vector<PlateElement>& plates, const std::vector<double>& nodeAreas, double max);

// Upper bound of the squared angular frequencies of all bending modes, times areal density over rigidity,
// 1/m4 (Gershgorin).
double stiffestNode(const std::vector<PlateElement>& plates, const std::vector<double>& nodeAreas);

}  // namespace drench
