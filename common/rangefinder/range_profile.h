#pragma once

#include <optional>
#include <string>

#include "geometry/sensor_rig.h"
#include "rangefinder/look_up_table.h"
#include "rangefinder/stripe_peaks.h"
#include "sensor/scan_set.h"
#include "sensor/stripe.h"

namespace geon::rangefinder {

// What a stripe measured: a point for every column (row) with a stripe at a distance that can be
// told, in the level frame L of the plan's head pose.
//
// `stripe.difference` must be kGray8 (decode PNG first) and `stripe.stripe_index` one of the
// plan's: else ContractViolation. A stripe with no usable light gives a profile without points.
// `seq` of the result is 0: the publisher counts.

// Distances by the look-up table of the stripe's laser, whose image size the stripe's must be (else
// ContractViolation). Outside the calibrated range there are no points.
//
// Source: thesis 3.2, equation 3.10 with z from the lens centre (errata): x = x' z / f.
sensor::RangeProfile MeasureProfile(const sensor::Stripe& stripe, const sensor::ScanPlan& plan,
                                    const LookUpTable& table, const geometry::SensorRig& rig,
                                    const PeakOptions& options = {});

struct TriangulationOptions {
  // Distances along the optical axis. What a ray meets outside them is no point: where a ray nearly
  // runs along the laser's plane, noise moves it anywhere.
  double nearest_m = 0.3;
  double farthest_m = 4.0;

  std::optional<std::string> Validate() const;
};

// Distances by the rig alone: each camera ray is cut with the laser's plane. As good as the rig's
// calibration. The stripe's image must have the size of the rig's B/W camera (else
// ContractViolation).
//
// Source: thesis figure 3.2, with the plane where it is instead of equation 3.9, which wants the
// fan parallel to the image's rows.
sensor::RangeProfile TriangulateStripe(const sensor::Stripe& stripe, const sensor::ScanPlan& plan,
                                       const geometry::SensorRig& rig,
                                       const PeakOptions& options = {},
                                       const TriangulationOptions& triangulation = {});

}  // namespace geon::rangefinder
