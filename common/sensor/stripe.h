#pragma once

#include <cstdint>
#include <string_view>

#include "sensor/image.h"

namespace geon::sensor {

enum class Laser { kNone = 0, kHorizontal = 1, kVertical = 2 };

// "horizontal", "vertical" or "none": in files and for people.
constexpr std::string_view ToString(Laser laser) {
  if (laser == Laser::kNone) return "none";
  return laser == Laser::kVertical ? "vertical" : "horizontal";
}

// The stripe_index of a sweep: asked for, every frame that is lit while the head turns is a stripe.
constexpr int32_t kSweptStripe = -1;

// Ask for one stripe: which laser, for which stripe of which scan. Desired state: re-sent until the
// stripe or its refusal arrives; the same (scan_id, stripe_index, attempt) is answered from memory.
// A sweep (kSweptStripe) is re-sent for as long as it is to go on.
struct ScanCommand {
  int64_t utime = 0;
  int32_t seq = 0;
  int64_t scan_id = 0;
  int32_t stripe_index = 0;
  int32_t attempt = 0;
  Laser laser = Laser::kNone;  // kNone: switch off and forget
};

enum class StripeStatus {
  kLit = 0,          // a proven pair of lit and unlit frames
  kNotLit = 1,       // the lit frame shows no laser light
  kLaserFault = 2,   // the laser board did not confirm
  kCameraFault = 3,  // no frames, stale or torn frames
  kMoving = 4,       // PTU or base did not stand still through the exposures
};

// A proven pair of frames (thesis section 3.1; errata to 3.6): lit minus unlit, saturating at 0,
// with the pose of the head and the base at the exposure.
struct Stripe {
  int64_t utime = 0;  // start of the lit exposure
  int32_t seq = 0;
  int64_t scan_id = 0;
  int32_t stripe_index = 0;
  int32_t attempt = 0;
  Laser laser = Laser::kNone;
  StripeStatus status = StripeStatus::kCameraFault;
  double pan_rad = 0.0;
  double tilt_rad = 0.0;
  double x_m = 0.0, y_m = 0.0, heading_rad = 0.0;  // odometry; the robot stands still during a scan
  int64_t lit_utime = 0;
  int64_t unlit_utime = 0;
  double lit_peak = 0.0;     // brightest levels of the difference inside and
  double noise_level = 0.0;  // its noise (robust standard deviation), grey levels
  Image difference;          // kGray8, or kPng of the same
};

}  // namespace geon::sensor
