#pragma once

#include "active_vision/head_angles.h"
#include "geometry/sensor_rig.h"
#include "sensor/image.h"

namespace geon::active_vision {

struct CenteringOptions {
  double step_fraction_1 = 0.75;  // of the free angle theta_d that one step takes
  int edge_px = 0;                // a box this close to an image edge touches it
};

enum class Centering {
  kInView,    // the whole target is in view: stay
  kTurn,      // turn the head to `head` and look again
  kTooLarge,  // touches opposite edges: back off and search anew
  kAtLimit,   // the head cannot turn further that way: move the robot
};

struct CenteringStep {
  Centering outcome = Centering::kInView;
  HeadAngles head;  // where to look next; the present angles unless kTurn
};

// The angle between the left image edge and a column, or the top edge and a row, seen from the
// lens.
//
// Source: equation 4.27, theta_d = d / b * fov, which is first-order only; derived here as a
// difference of arctangents.
double AngleFromEdge(double pixel_px, double center_px, double focal_px);

// One step towards having the whole target in the colour image: for each image edge the box
// touches, 0.75 of the angle that is free on the other side.
//
// Source: thesis 4.2.2, figure 4.8, both axes. Derived from the rig's transforms: panning a pitched
// or tilted head moves the view by less than the pan angle. "Still partially out of view after
// several iterations" is for the caller, who counts.
CenteringStep CenterTarget(const geometry::SensorRig& rig, const sensor::PixelBox& box,
                           const HeadAngles& head, const HeadLimits& limits,
                           const CenteringOptions& options = {});

}  // namespace geon::active_vision
