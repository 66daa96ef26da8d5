#pragma once

#include <array>
#include <optional>
#include <vector>

#include "active_vision/head_angles.h"
#include "geometry/sensor_rig.h"
#include "sensor/image.h"
#include "sensor/scan_set.h"

namespace geon::active_vision {

struct StripePlacementOptions {
  // Where the stripes cut the target's box, from the top (horizontal) or the left (vertical).
  std::array<double, 3> fractions_1 = {0.25, 0.5, 0.75};
};

// What was seen of the target and where it stands.
struct StripeTarget {
  sensor::PixelBox box;  // in the colour image taken with the head at `head`
  HeadAngles head;
  double distance_m = 0.0;  // horizontal, from the B/W camera to its foot
};

struct StripePlacement {
  std::vector<sensor::PlannedStripe>
      stripes;  // horizontal top to bottom, then vertical left to right
  // Those whose laser plane meets no such ray, or only beyond the limits; angles as near as they
  // get.
  std::vector<sensor::PlannedStripe> unreachable;
  bool complete() const { return unreachable.empty(); }
};

// The three tilts and three pans that put the stripes at the quarters of the target.
//
// Source: thesis 4.2.4, equations 4.30-4.47. Derived, as the errata ask: the wanted point is where
// the colour camera's ray through the wanted row (column) meets the vertical plane across the line
// of sight at the target's distance; the head turns until the laser's plane holds that point.
// Deviation: with it the head also turns on the other axis until the B/W camera has the target's
// middle in its middle, because close by the 65 mm between the cameras would push a tall target out
// of its view.
StripePlacement PlaceStripes(const geometry::SensorRig& rig, const StripeTarget& target,
                             const HeadLimits& limits, const StripePlacementOptions& options = {});

// The head's angles for one of them, as PlaceStripes finds them; nothing when the laser's plane
// meets no such ray or the head cannot turn there.
std::optional<HeadAngles> PlaceStripe(const geometry::SensorRig& rig, const StripeTarget& target,
                                      const HeadLimits& limits, sensor::Laser laser,
                                      double fraction);

}  // namespace geon::active_vision
