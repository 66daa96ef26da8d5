#pragma once

namespace geon::active_vision {

// Source: thesis section 3.3 (the pan-tilt unit) and the PTU-46-17.5 manual (limits).
//
// Where the head looks. Positive pan looks left, positive tilt looks up.
struct HeadAngles {
  double pan_rad = 0.0;
  double tilt_rad = 0.0;
  friend bool operator==(const HeadAngles&, const HeadAngles&) = default;
};

// How far the pan-tilt unit turns (PtuState reports it; defaults: PTU-46-17.5).
struct HeadLimits {
  double pan_min_rad = -2.7737;  // -158.92 degrees
  double pan_max_rad = 2.7737;
  double tilt_min_rad = -0.8142;  // -46.65 degrees
  double tilt_max_rad = 0.5421;   // +31.06 degrees

  bool Contain(const HeadAngles& head) const {
    return head.pan_rad >= pan_min_rad && head.pan_rad <= pan_max_rad &&
           head.tilt_rad >= tilt_min_rad && head.tilt_rad <= tilt_max_rad;
  }
  HeadAngles Clamp(HeadAngles head) const;
};

}  // namespace geon::active_vision
