#pragma once

#include <optional>

#include "active_vision/ground_distance.h"
#include "mission/phase.h"

namespace geon::mission {

// Where the target of a view stands if its support has this height, and how far the range finder
// has to reach for its middle.
struct StandingTarget {
  active_vision::TargetFoot foot;
  double range_m = 0.0;
};
std::optional<StandingTarget> Standing(const geometry::SensorRig& rig, const HeadSighting& view,
                                       double support_height_m);

// Goes on with the likeliest support that puts the target of `context->view` within the range
// finder's reach (thesis 3.2: up to 2 m); too near: step back; no such support: the mission ends.
Next ChooseScan(Context* context);

// Gives a height up when another one puts the target within reach; says whether it did.
bool RefuteForAnother(Context* context, double support_height_m);

// The height that fits a measured horizontal distance from the B/W camera best.
// Nothing when none comes within `tolerance_m`.
std::optional<double> HeightByDistance(const Context& context, double distance_m,
                                       double tolerance_m);

// Median horizontal distance of what a horizontal stripe lit in the middle of the target, or
// nothing when there are too few points. The head had the target's middle in the middle of the B/W
// picture.
std::optional<double> MeasuredDistance(const sensor::RangeProfile& profile,
                                       const geometry::PinholeCamera& stripe_camera, int box_w_px);

}  // namespace geon::mission
