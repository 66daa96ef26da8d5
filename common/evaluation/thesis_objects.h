#pragma once

#include <string>
#include <vector>

#include "geons/geon_shape.h"

namespace geon::evaluation {

// One of the objects of an experiment, with the stable positions it is shown in. The position in
// `shape` itself is not used.
struct ExperimentObject {
  std::string name;
  geons::GeonShape shape;
  std::vector<int> positions;
};

// The 28 objects of thesis section 6.1: four variations of each geon, 1 strong to 4 slight, in 60
// stable positions altogether.
//
// Source: thesis section 6.1, figures 6.2-6.10, tables 6.1-6.7. The tables give the positions; the
// figures with the dimensions are missing, so the dimensions are ours: about 0.2 m, to fit the
// image at 1 m; smaller ends of 25, 43, 60 and 74 % of the larger; axes bent by 150 to 55 degrees,
// the first bent cylinder a half torus, whose flat ends let it stand as an arch; cuboids, cylinders
// and ellipsoids from compact to 2.4 times as long as thick. An edge of the hand-sized blocks is
// rounded by about 1 mm (GeonMesh).
std::vector<ExperimentObject> ThesisObjects();

}  // namespace geon::evaluation
