#pragma once

#include <cstdint>
#include <optional>

#include "attention/color_model.h"
#include "attention/expose_for_target.h"
#include "attention/find_target.h"
#include "sensor/image.h"

namespace geon::color_camera {

struct ExposureControlOptions {
  attention::ColorModel target_color;
  attention::ExposureOptions law;
  double first_exposure_s = 0.010;  // of frames that do not say theirs, before one was asked for
  int old_frames = 3;               // that may still come as they were after a request
};

// Sets the exposure of a colour camera by the frames it delivers: for the target where one is in
// view, or where one would be if the frame had been exposed longer; else for the whole picture
// (attention/expose_for_target.h).
class ExposureControl {
 public:
  explicit ExposureControl(const ExposureControlOptions& options);

  // The exposure to ask the camera for; nothing while it is good, and while frames may be older
  // than the last request. A request that came to nothing is seen in the frames and made again.
  // Input: kRgb8 or kBgr8, `seq` as the source counts.
  std::optional<double> Judge(const sensor::Image& frame);

 private:
  ExposureControlOptions options_;
  attention::TargetFinder finder_;
  attention::TargetFinder faint_finder_;  // of a target that a longer exposure would show
  double exposure_s_;                     // last asked for
  std::optional<int64_t> asked_seq_;
};

}  // namespace geon::color_camera
