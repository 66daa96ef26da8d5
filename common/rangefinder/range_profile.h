#pragma once

#include "geometry/sensor_rig.h"
#include "rangefinder/look_up_table.h"
#include "rangefinder/stripe_peaks.h"
#include "sensor/scan_set.h"
#include "sensor/stripe.h"

namespace geon::rangefinder {

// What a stripe measured: a point for every column (row) with a stripe inside the calibrated range,
// in the level frame L of the plan's head pose.
//
// Source: thesis 3.2, equation 3.10 with z from the lens centre (errata): x = x' z / f.
// `stripe.difference` must be kGray8 (decode PNG first) and of the table's size, `stripe.laser` the
// table's, `stripe.stripe_index` one of the plan's: else ContractViolation. A stripe with no usable
// light gives a profile without points. `seq` of the result is 0: the publisher counts.
sensor::RangeProfile MeasureProfile(const sensor::Stripe& stripe, const sensor::ScanPlan& plan,
                                    const LookUpTable& table, const geometry::SensorRig& rig,
                                    const PeakOptions& options = {});

}  // namespace geon::rangefinder
