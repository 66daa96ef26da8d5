#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/sensor_rig.h"
#include "procs/recognizer/stripe_calibration.h"
#include "rangefinder/stripe_peaks.h"
#include "recognition/recognition_options.h"
#include "sensor/geon_verdict.h"
#include "sensor/scan_set.h"
#include "sensor/stripe.h"
#include "sensor/target_mask.h"

namespace geon::recognizer {

struct ScanAssemblerOptions {
  recognition::RecognitionOptions recognition;
  rangefinder::PeakOptions peaks;
  // A stripe with fewer points on the target counts as missing, and the planner lays it again.
  int fewest_points = 12;
};

// The profiles of a plan as a scan set: the level frame L and the camera's place in it follow from
// the head's pose in the plan.
sensor::ScanSet MakeScanSet(const geometry::SensorRig& rig, const sensor::ScanPlan& plan,
                            std::vector<sensor::RangeProfile> profiles);

// Turns plans and stripes into profiles, and complete scans into verdicts. Knows no bus and no
// clock: what is heard goes in, what is to be said comes out, stamped with the stripes' own times.
// The same messages in the same order give the same answers bit for bit, live or from a log.
//
// - A plan heard again changes nothing; a plan with another scan_id, or other content, starts a new
// scan.
// - The mask of the same scan tells the points' colours, whenever it comes; without it they are not
//   known.
// - A stripe heard again is answered from memory. Stripes may come in any order. A stripe of an
// unknown
//   scan (this process was started in mid-scan) is refused, and the planner starts anew.
// - Each attempt at a stripe is measured; of several good ones the latest attempt counts.
// - The stripes of a sweep come without a place of their own: each counts for the planned stripe of
// its laser
//   that it lies nearest to, and of several there the nearest; its profile says where it lies.
//   They do not complete a scan: the planner ends it.
// - The scan is complete when every planned stripe is good, or when the planner ends it
// (SCAN_COMMAND with
//   no laser) after giving up on some. The verdict is given once, and repeated when the end is
//   told again.
class ScanAssembler {
 public:
  // Without a calibration, distances come from the rig.
  ScanAssembler(geometry::SensorRig rig, std::optional<StripeCalibration> calibration,
                const ScanAssemblerOptions& options);

  struct Answer {
    sensor::RangeProfile profile;
    std::optional<sensor::GeonVerdict> verdict;
  };

  void Take(const sensor::ScanPlan& plan);
  void Take(const sensor::TargetMask& mask);
  Answer Take(const sensor::Stripe& stripe);
  std::optional<sensor::GeonVerdict> Take(const sensor::ScanCommand& command);

  // The scan being assembled, as far as it is: what a verdict would be given on.
  sensor::ScanSet CurrentScan() const;
  int planned_stripes() const { return plan_ ? static_cast<int>(plan_->stripes.size()) : 0; }
  int good_stripes() const { return static_cast<int>(good_.size()); }

 private:
  bool IsKnown(const sensor::Stripe& stripe) const;
  sensor::RangeProfile TakeSwept(sensor::Stripe stripe);
  sensor::RangeProfile Measure(const sensor::Stripe& stripe) const;
  sensor::RangeProfile MeasurePoints(const sensor::Stripe& plain) const;
  sensor::RangeProfile Tagged(sensor::RangeProfile profile) const;
  void CountTargetPoints(sensor::RangeProfile* profile) const;
  sensor::GeonVerdict GiveVerdict();

  geometry::SensorRig rig_;
  std::optional<StripeCalibration> calibration_;
  ScanAssemblerOptions options_;
  std::optional<sensor::ScanPlan> plan_;
  std::optional<sensor::TargetMask> mask_;                               // heard last
  std::map<std::pair<int32_t, int32_t>, sensor::RangeProfile> answers_;  // (stripe, attempt)
  std::map<int32_t, sensor::RangeProfile> good_;                         // by stripe
  int64_t newest_utime_ = 0;
  std::optional<sensor::GeonVerdict> verdict_;
};

}  // namespace geon::recognizer
