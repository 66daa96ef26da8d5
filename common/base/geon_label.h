#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace geon {

// The seven geons of the thesis (section 2.3.1). The order is that of every posterior, table and
// confusion matrix of the system, and of the wire format; it never changes.
enum class GeonLabel {
  kCuboid = 0,
  kCylinder,
  kEllipsoid,
  kTaperedCuboid,
  kTaperedCylinder,
  kBentCuboid,
  kBentCylinder,
};

inline constexpr int kGeonLabelCount = 7;

inline constexpr std::array<std::string_view, kGeonLabelCount> kGeonLabelNames = {
    "cuboid",           "cylinder",    "ellipsoid",    "tapered_cuboid",
    "tapered_cylinder", "bent_cuboid", "bent_cylinder"};

constexpr std::string_view ToString(GeonLabel label) {
  return kGeonLabelNames[static_cast<size_t>(label)];
}

// Nothing for a name that is not one of the seven.
constexpr std::optional<GeonLabel> GeonLabelFromString(std::string_view name) {
  for (size_t i = 0; i < kGeonLabelNames.size(); ++i) {
    if (kGeonLabelNames[i] == name) return static_cast<GeonLabel>(i);
  }
  return std::nullopt;
}

}  // namespace geon
