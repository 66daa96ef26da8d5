#include "evaluation/viewing_sphere.h"

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::evaluation {

std::vector<ViewingCell> ViewingSphere(int low_deg, int high_deg) {
  constexpr int kStep_deg = 10;
  constexpr double kMiddle_deg = 0.5 * kStep_deg;
  Require(0 <= low_deg && low_deg < high_deg && high_deg <= 90 && low_deg % kStep_deg == 0 &&
              high_deg % kStep_deg == 0,
          "the viewing sphere's elevations are multiples of 10 degrees from 0 to 90, low < high");
  std::vector<ViewingCell> cells;
  for (int elevation_deg = low_deg; elevation_deg < high_deg; elevation_deg += kStep_deg) {
    for (int azimuth_deg = 0; azimuth_deg < 360; azimuth_deg += kStep_deg) {
      cells.push_back({RadiansFromDegrees(elevation_deg + kMiddle_deg),
                       RadiansFromDegrees(azimuth_deg + kMiddle_deg)});
    }
  }
  return cells;
}

}  // namespace geon::evaluation
