#pragma once

#include <vector>

namespace geon::evaluation {

// The middle of one cell of the viewing sphere: where the camera stands, seen from the geon.
struct ViewingCell {
  double elevation_rad = 0.0;
  double azimuth_rad = 0.0;
};

// Source: thesis section 6.1, figure 6.1: elevations from 30 to 70 degrees and all azimuths, in
// cells of 10 by 10 degrees: 4 x 36 = 144 views, elevation by elevation.
//
// Other limits are multiples of 10 degrees, low < high, within 0 and 90 (ContractViolation).
std::vector<ViewingCell> ViewingSphere(int low_deg = 30, int high_deg = 70);

}  // namespace geon::evaluation
