#pragma once

#include "geometry/sensor_rig.h"
#include "sensor/scan_set.h"
#include "sensor/target_mask.h"

namespace geon::rangefinder {

// Tells each point of a profile how likely the target's colour is where it lies (`on_color_1`).
//
// Source: thesis chapter 7, which wishes for a range sensor that sees colour (the polychromatic one
// of Baribeau, Rioux and Godin 1992). Here the point is projected into the colour camera as it
// stood when the target was seen, and the probability is that part of the target's mask which lies
// within `edge_px` of it: calibration errs by so much. 0.5 where the colour camera does not look.
//
// Limit: a point that the colour camera, which sits above the B/W camera, cannot see gets the
// colour of what hides it. So 0 is proof of background, 1 none of target.
//
// `plan` gives frame L of the points. A mask of another scan, or whose runs do not fill its box,
// breaks the contract.
void TagColors(const sensor::TargetMask& mask, const sensor::ScanPlan& plan,
               const geometry::SensorRig& rig, sensor::RangeProfile* profile, int edge_px = 3);

}  // namespace geon::rangefinder
