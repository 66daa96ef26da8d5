#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "evaluation/shape_experiment.h"
#include "evaluation/success_rate.h"

namespace geon::cli {

// The member `rates` of results.json (contract geon.experiment.v1), all from the trials alone:
// `all mean_of_cells classes rows elevations views decided decided_right
// expected_calibration_error reliability`. A rate is {right, n, rate, wilson95}; `decided` has
// `decided` in place of `right`.
nlohmann::json RatesJson(std::span<const evaluation::Subject> subjects,
                         std::span<const evaluation::ShapeTrial> trials);

// {right, n, rate, wilson95}; `counted` is the first one's name.
nlohmann::json RateJson(const evaluation::SuccessRate& rate, const char* counted = "right");

// Cells lie at whole degrees.
int WholeDegrees(double angle_rad);

}  // namespace geon::cli
