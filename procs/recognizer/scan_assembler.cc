#include "procs/recognizer/scan_assembler.h"

#include <algorithm>
#include <cmath>

#include "active_vision/laid_fraction.h"
#include "procs/recognizer/difference_image.h"
#include "rangefinder/color_tags.h"
#include "rangefinder/range_profile.h"
#include "recognition/label_points.h"
#include "recognition/recognize_geon.h"

namespace geon::recognizer {
namespace {

using sensor::ProfileStatus;

bool SameStripe(const sensor::PlannedStripe& a, const sensor::PlannedStripe& b) {
  return a.laser == b.laser && a.fraction == b.fraction && a.pan_rad == b.pan_rad &&
         a.tilt_rad == b.tilt_rad;
}

// Whether two plans are one, sent twice.
bool SamePlan(const sensor::ScanPlan& a, const sensor::ScanPlan& b) {
  return a.scan_id == b.scan_id && a.target_box == b.target_box && a.pan_rad == b.pan_rad &&
         a.tilt_rad == b.tilt_rad && a.support_height_m == b.support_height_m &&
         a.distance_m == b.distance_m &&
         std::equal(a.stripes.begin(), a.stripes.end(), b.stripes.begin(), b.stripes.end(),
                    SameStripe);
}

bool LiesInPicture(const sensor::PixelBox& box, const geometry::PinholeCamera& camera) {
  return box.u_px >= 0 && box.v_px >= 0 && box.u_px + box.w_px <= camera.width_px &&
         box.v_px + box.h_px <= camera.height_px;
}

// The answer to a stripe that nothing was measured on.
sensor::RangeProfile EmptyProfile(const sensor::Stripe& stripe, ProfileStatus status) {
  sensor::RangeProfile profile;
  profile.utime = stripe.utime;
  profile.scan_id = stripe.scan_id;
  profile.stripe_index = stripe.stripe_index;
  profile.attempt = stripe.attempt;
  profile.laser = stripe.laser;
  profile.status = status;
  return profile;
}

}  // namespace

sensor::ScanSet MakeScanSet(const geometry::SensorRig& rig, const sensor::ScanPlan& plan,
                            std::vector<sensor::RangeProfile> profiles) {
  const geometry::RigidTransform X_RB = rig.StripeCameraPose(plan.pan_rad, plan.tilt_rad);
  const geometry::RigidTransform X_LB =
      geometry::LevelFrame(X_RB, plan.support_height_m).inverse() * X_RB;
  sensor::ScanSet scan;
  scan.scan_id = plan.scan_id;
  scan.camera_position_L_m = X_LB.translation();
  scan.rotation_LB = X_LB.linear();
  scan.target_box = plan.target_box;
  scan.profiles = std::move(profiles);
  return scan;
}

ScanAssembler::ScanAssembler(geometry::SensorRig rig, std::optional<StripeCalibration> calibration,
                             const ScanAssemblerOptions& options)
    : rig_(std::move(rig)), calibration_(std::move(calibration)), options_(options) {
  options_.recognition.Validate();
}

void ScanAssembler::Take(const sensor::ScanPlan& plan) {
  if (plan_ && SamePlan(*plan_, plan)) return;
  plan_ = plan;
  answers_.clear();
  good_.clear();
  verdict_.reset();
  newest_utime_ = 0;
}

void ScanAssembler::Take(const sensor::TargetMask& mask) {
  if (LiesInPicture(mask.box, rig_.color_camera)) mask_ = mask;
}

bool ScanAssembler::IsKnown(const sensor::Stripe& stripe) const {
  if (!plan_ || stripe.scan_id != plan_->scan_id) return false;
  const auto of_laser = [&](const sensor::PlannedStripe& planned) {
    return planned.laser == stripe.laser;
  };
  if (stripe.stripe_index == sensor::kSweptStripe) {
    return std::any_of(plan_->stripes.begin(), plan_->stripes.end(), of_laser);
  }
  const auto index = static_cast<size_t>(stripe.stripe_index);
  return stripe.stripe_index >= 0 && index < plan_->stripes.size() &&
         of_laser(plan_->stripes[index]);
}

ScanAssembler::Answer ScanAssembler::Take(const sensor::Stripe& stripe) {
  if (!IsKnown(stripe)) return {EmptyProfile(stripe, ProfileStatus::kRefused), std::nullopt};
  if (stripe.stripe_index == sensor::kSweptStripe) return {TakeSwept(stripe), verdict_};

  const std::pair<int32_t, int32_t> key(stripe.stripe_index, stripe.attempt);
  const auto answered = answers_.find(key);
  if (answered != answers_.end()) return {answered->second, verdict_};

  const sensor::RangeProfile& profile = answers_.emplace(key, Measure(stripe)).first->second;
  newest_utime_ = std::max(newest_utime_, stripe.utime);
  if (profile.status == ProfileStatus::kOk && !verdict_) {
    const auto [best, first] = good_.emplace(stripe.stripe_index, profile);
    if (!first && best->second.attempt < profile.attempt) best->second = profile;
  }
  if (!verdict_ && good_.size() == plan_->stripes.size()) verdict_ = GiveVerdict();
  return {profile, verdict_};
}

sensor::RangeProfile ScanAssembler::TakeSwept(sensor::Stripe stripe) {
  std::vector<int32_t> places;
  for (size_t k = 0; k < plan_->stripes.size(); ++k) {
    if (plan_->stripes[k].laser == stripe.laser) places.push_back(static_cast<int32_t>(k));
  }
  stripe.stripe_index = places.front();
  sensor::RangeProfile profile = Measure(stripe);
  const geometry::RigidTransform X_CL =
      geometry::ColorFromLevel(rig_, plan_->pan_rad, plan_->tilt_rad, plan_->support_height_m);
  const auto laid_1 =
      active_vision::LaidFraction(profile, X_CL, rig_.color_camera, plan_->target_box);
  if (!laid_1) {
    profile.status = ProfileStatus::kMissing;
    return profile;
  }
  profile.fraction = *laid_1;
  const auto off_1 = [&](int32_t place) {
    return std::abs(*laid_1 - plan_->stripes[static_cast<size_t>(place)].fraction);
  };
  profile.stripe_index = *std::min_element(
      places.begin(), places.end(), [&](int32_t a, int32_t b) { return off_1(a) < off_1(b); });
  newest_utime_ = std::max(newest_utime_, stripe.utime);
  if (profile.status != ProfileStatus::kOk || verdict_) return profile;
  const auto [best, first] = good_.emplace(profile.stripe_index, profile);
  if (!first && Misplacement(*plan_, profile) < Misplacement(*plan_, best->second)) {
    best->second = profile;
  }
  return profile;
}

std::optional<sensor::GeonVerdict> ScanAssembler::Take(const sensor::ScanCommand& command) {
  const bool ends = plan_ && command.scan_id == plan_->scan_id &&
                    command.laser == sensor::Laser::kNone && !good_.empty();
  if (!ends) return std::nullopt;
  if (!verdict_) verdict_ = GiveVerdict();
  return verdict_;
}

sensor::ScanSet ScanAssembler::CurrentScan() const {
  if (!plan_) return {};
  std::vector<sensor::RangeProfile> profiles;
  for (const auto& [index, profile] : good_) profiles.push_back(Tagged(profile));
  return MakeScanSet(rig_, *plan_, std::move(profiles));
}

sensor::RangeProfile ScanAssembler::Measure(const sensor::Stripe& stripe) const {
  if (stripe.status == sensor::StripeStatus::kNotLit) {
    return EmptyProfile(stripe, ProfileStatus::kMissing);
  }
  if (stripe.status != sensor::StripeStatus::kLit) {
    return EmptyProfile(stripe, ProfileStatus::kRefused);
  }
  // The tables were made with images of this size (LoadStripeCalibration).
  const geometry::PinholeCamera& camera = rig_.stripe_camera;
  const Result<sensor::Image> difference =
      DifferenceImage(stripe.difference, camera.width_px, camera.height_px);
  if (!difference.ok()) return EmptyProfile(stripe, ProfileStatus::kRefused);
  sensor::Stripe plain = stripe;
  plain.difference = *difference;
  sensor::RangeProfile profile = MeasurePoints(plain);
  CountTargetPoints(&profile);
  profile.status =
      profile.on_target >= options_.fewest_points ? ProfileStatus::kOk : ProfileStatus::kMissing;
  return profile;
}

sensor::RangeProfile ScanAssembler::MeasurePoints(const sensor::Stripe& plain) const {
  if (!calibration_) return rangefinder::TriangulateStripe(plain, *plan_, rig_, options_.peaks);
  const rangefinder::LookUpTable& table =
      plain.laser == sensor::Laser::kHorizontal ? calibration_->horizontal : calibration_->vertical;
  return rangefinder::MeasureProfile(plain, *plan_, table, rig_, options_.peaks);
}

// The region of interest needs horizontal stripes; this one is as good as those already there.
void ScanAssembler::CountTargetPoints(sensor::RangeProfile* profile) const {
  sensor::ScanSet scan = CurrentScan();
  scan.profiles.push_back(Tagged(*profile));
  const std::vector<bool> on_target =
      recognition::FindTargetPoints(scan, options_.recognition.BackgroundChosen()).back();
  profile->on_target = static_cast<int32_t>(std::count(on_target.begin(), on_target.end(), true));
}

sensor::RangeProfile ScanAssembler::Tagged(sensor::RangeProfile profile) const {
  if (mask_ && mask_->scan_id == plan_->scan_id) {
    rangefinder::TagColors(*mask_, *plan_, rig_, &profile);
  }
  return profile;
}

sensor::GeonVerdict ScanAssembler::GiveVerdict() {
  sensor::GeonVerdict verdict = recognition::RecognizeGeon(CurrentScan(), options_.recognition);
  verdict.utime = newest_utime_;
  return verdict;
}

}  // namespace geon::recognizer
