#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/geon_label.h"
#include "base/status.h"

namespace geon::cli {

// What really stood in the simulated world: the first line of a truth file (geon.truth.v1, written
// by geon-sim). Positions are in the frame where odometry started, like everything the robot knows.
struct Truth {
  struct Object {
    std::string kind;
    std::optional<GeonLabel> label;
    double x_m = 0.0;
    double y_m = 0.0;
  };
  std::vector<Object> objects;

  // The label of the labelled object nearest to a place; nothing if there is none.
  std::optional<GeonLabel> LabelNear(double x_m, double y_m) const;
};

Result<Truth> LoadTruth(const std::filesystem::path& file);

}  // namespace geon::cli
