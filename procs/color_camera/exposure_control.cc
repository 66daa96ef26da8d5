#include "procs/color_camera/exposure_control.h"

#include <cmath>

namespace geon::color_camera {

namespace {

constexpr double kFaint_1 = 0.4;  // of the levels at which a target has its colour

}  // namespace

ExposureControl::ExposureControl(const ExposureControlOptions& options)
    : options_(options),
      finder_(options.target_color, attention::AttentionOptions()),
      faint_finder_(attention::AtLevel(options.target_color, kFaint_1),
                    attention::AttentionOptions()),
      exposure_s_(options.first_exposure_s) {}

std::optional<double> ExposureControl::Judge(const sensor::Image& frame) {
  constexpr double kSame_1 = 0.02;  // cameras round
  if (asked_seq_) {
    const int64_t since = frame.seq - *asked_seq_;  // negative: the camera started anew
    if (since >= 0 && since <= options_.old_frames) return std::nullopt;
    asked_seq_.reset();
  }
  const double exposure_s = frame.exposure_s.value_or(exposure_s_);
  attention::TargetSighting target = finder_.Find(frame);
  if (!target.target) target = faint_finder_.Find(frame);
  const attention::SeenLight seen = attention::MeasureLight(frame, target.mask);
  const double next_s = attention::NextExposure(exposure_s, seen, options_.law);
  if (std::abs(next_s / exposure_s - 1.0) < kSame_1) return std::nullopt;
  exposure_s_ = next_s;
  asked_seq_ = frame.seq;
  return next_s;
}

}  // namespace geon::color_camera
