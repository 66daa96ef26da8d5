#pragma once

#include <Eigen/Core>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/geon_label.h"
#include "sensor/geon_verdict.h"
#include "sensor/scan_set.h"

namespace geon::cli {

// A stripe thinned out for drawing: its points on the target in frame B (x right, y down, z away
// from the camera), in tenths of a millimetre, broken where the stripe is.
struct DrawnStripe {
  sensor::Laser laser = sensor::Laser::kHorizontal;
  double fraction_1 = 0.5;
  std::vector<std::vector<Eigen::Vector3i>> pieces;
};

// A view that a reader of the report should see, and what it takes to draw it.
struct WorstView {
  int t = 0;  // its trial, and what that trial says:
  bool right = false;
  double confidence_1 = 0.0;
  std::array<double, kGeonLabelCount> posterior{};
  std::vector<std::string> reasons;
  std::vector<DrawnStripe> stripes;
  std::string picture_uri;  // what the camera saw, as a data URI; empty: no camera looked
};

inline constexpr size_t kMostWorstViews = 12;

// Puts a view among the worst: at most twelve wrong ones, the most confident first; as long as none
// is wrong the right ones, the least confident first; of equals the lower t. The worst of a whole
// are the worst of the worst of its parts, in whatever order they come.
void AddWorstView(WorstView view, std::vector<WorstView>* worst);
// Whether AddWorstView would keep it: t, right and confidence_1 are looked at.
bool IsAmongWorst(const WorstView& view, const std::vector<WorstView>& worst);

// The six stripes of a scan as they are drawn.
std::vector<DrawnStripe> DrawStripes(const sensor::ScanSet& scan);

// {"t":..,"posterior":{..},"reasons":[..],"stripes":[{"laser":..,"fraction":..,
// "pieces_tenth_mm":[[x,y,z,x,y,z,..],..]}],"picture":".."}, the last only where there is one.
// `right` and `confidence_1` are the trial's.
nlohmann::json ToJson(const WorstView& view);
// Throws what nlohmann::json or std::runtime_error say of damaged ones.
WorstView ParseWorstView(const nlohmann::json& value);

}  // namespace geon::cli
