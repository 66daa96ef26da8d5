#pragma once

#include <optional>

#include "base/angles.h"
#include "geometry/rigid_transform.h"
#include "sim/surroundings.h"

namespace geon::sim {

// A Polaroid ranger's beam and ear. Strengths are both ways, a wall met squarely being 1.
struct SonarEchoOptions {
  double half_cone_rad = RadiansFromDegrees(15.0);  // the nominal beam: a tenth is left at its edge
  // Beyond it the side lobes: flat walls answer out to 42 degrees off the axis (Cao and Borenstein
  // 2002).
  double side_lobe_1 = 0.03;
  double side_lobe_end_rad = RadiansFromDegrees(42.0);
  double scatter_1 = 0.12;  // of an edge, a pole, a wall's upper rim met squarely
  double corner_1 = 0.5;    // by way of both its walls
  // A wall met squarely is heard so far; echoes fade with the square of the range (35 ft).
  double reach_m = 10.67;
};

// The range of the first echo of one ping that is loud enough: nothing when there is none. X_WS has
// the transducer at its origin, x along the beam, z up. `loudness_1`: how much louder than usual
// this ping happens to be.
//
// Source: hardware card 5. Sound of 7 mm is mirrored by all that is smooth. A plane is heard from
// the foot of the perpendicular alone, if that is on it and in the beam or its side lobes, so that
// several neighbours of a ring read the same range of one wall and the others nothing. Edges that
// are met squarely, poles and corners answer too, weakly or by a detour. Everything is as hard as a
// board: no colour is heard.
std::optional<double> SonarEcho_m(const Surroundings& surroundings,
                                  const geometry::RigidTransform& X_WS,
                                  const SonarEchoOptions& options, double loudness_1 = 1.0);

}  // namespace geon::sim
