#pragma once

#include <optional>
#include <vector>

#include "active_vision/place_stripes.h"
#include "geometry/sensor_rig.h"
#include "sensor/scan_set.h"

namespace geon::active_vision {

// How far the target's surface is where a stripe is wanted, as the stripes already laid tell:
// horizontal, from the B/W camera, as StripeTarget::distance_m. Nothing when they have too few
// points inside the target's box.
//
// Source: ours. Thesis 4.2.4 takes the distance of the target's foot for all of it; a surface 5 cm
// nearer moves the vertical laser's stripe, 125 mm beside the camera, by 6 mm at 1 m.
// `measured` are in the level frame of the look at which the box was taken, above a support
// `support_height_m` high. The points nearest in the picture to the wanted place count.
std::optional<double> SurfaceDistance(const geometry::SensorRig& rig, const StripeTarget& target,
                                      double support_height_m,
                                      const std::vector<sensor::RangeProfile>& measured,
                                      sensor::Laser laser, double fraction);

}  // namespace geon::active_vision
