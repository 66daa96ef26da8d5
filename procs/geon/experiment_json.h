#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "evaluation/confusion.h"

namespace geon::cli {

// What the results of several experiments have in common (contract geon.experiment.v1).

inline constexpr const char* kExperimentFormat = "geon.experiment.v1";

// Nothing is null.
nlohmann::json OptionalJson(const std::optional<double>& value);
std::optional<double> ParseOptional(const nlohmann::json& value);
nlohmann::json LabelJson(const std::optional<GeonLabel>& label);
// Throws std::bad_optional_access for another name.
GeonLabel ParseLabel(const nlohmann::json& value);
std::optional<GeonLabel> ParseOptionalLabel(const nlohmann::json& value);

// {truth, object, position, range_m, n, counts, undecided}; `n` counts those without an answer too.
nlohmann::json CellJson(const evaluation::ConfusionRow& row, int n, const nlohmann::json& range_m);

// What was said, or not said, of a subject.
struct Answer {
  evaluation::Subject subject;
  std::optional<double> range_m;
  std::optional<GeonLabel> label;
  bool decided = false;
};
// A cell for each subject at each range, in the order in which they first come.
nlohmann::json AnswerCells(const std::vector<Answer>& answers);

}  // namespace geon::cli
