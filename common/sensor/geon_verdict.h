#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/geon_label.h"
#include "sensor/stripe.h"

namespace geon::sensor {

// What one profile contributes to the evidence (thesis section 5.3).
struct ProfileEvidence {
  Laser laser = Laser::kHorizontal;
  double fraction = 0.5;
  int points = 0;    // after background removal
  int segments = 0;  // 2 or more: a gap or a depth step splits it (thesis figure 5.10)
  int curves = 0;
  int corners = 0;
  int concavities = 0;
  double length_m = 0.0;             // between the end points
  std::vector<double> arc_length_m;  // abscissa of the theta-plot
  std::vector<double> theta_rad;     // difference of slope along the profile (figure 5.7)
};

// Bending (section 5.4): two segments, a concavity, or a concave edge through the end points (5.3).
struct BendingEvidence {
  bool two_segments = false;
  bool concavity = false;
  bool concave_edge = false;
  double concave_edge_m = 0.0;  // largest left side of (5.3)
  bool found() const { return two_segments || concavity || concave_edge; }
};

// Tapering (section 5.5): monotone lengths (5.4-5.7), or unequal end-point steps (5.8).
struct TaperingEvidence {
  bool monotone_horizontal = false;
  bool monotone_vertical = false;
  bool asymmetric_ends = false;
  double asymmetry_m = 0.0;  // largest left side of (5.8)
  bool found() const { return monotone_horizontal || monotone_vertical || asymmetric_ends; }
};

// Contract geon.verdict.v1.
struct GeonVerdict {
  int64_t utime = 0;
  int32_t seq = 0;
  int64_t scan_id = 0;
  GeonLabel label = GeonLabel::kCuboid;
  double confidence = 0.0;
  std::array<double, kGeonLabelCount> posterior{};
  bool decided = false;
  std::string method;
  BendingEvidence bending;
  TaperingEvidence tapering;
  std::vector<ProfileEvidence> profiles;
  std::vector<std::string> reasons;  // the walk through the tree, in words
};

}  // namespace geon::sensor
