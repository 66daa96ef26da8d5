#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "evaluation/shape_experiment.h"
#include "evaluation/success_rate.h"

namespace geon::evaluation {

// What was said about one object in one position: a row of tables 6.1-6.7.
struct ConfusionRow {
  Subject subject;
  std::array<int, kGeonLabelCount> counts{};  // by answer
  int undecided = 0;                          // answers that were mere guesses
  int n() const;
  SuccessRate rate() const;
};

// The rate of one viewing cell over all objects: a column of figure 6.11.
struct CellRate {
  ViewingCell cell;
  SuccessRate rate;
};

// A row for each subject that has trials, in the order of the subjects.
std::vector<ConfusionRow> CountAnswers(std::span<const Subject> subjects,
                                       std::span<const ShapeTrial> trials);

SuccessRate OverallRate(std::span<const ConfusionRow> rows);
std::array<SuccessRate, kGeonLabelCount> RatesByClass(std::span<const ConfusionRow> rows);

// The class with the lowest rate, the row, the viewing cell: of equals the first. Nothing without
// trials.
std::optional<GeonLabel> WorstClass(std::span<const ConfusionRow> rows);
std::optional<ConfusionRow> WorstRow(std::span<const ConfusionRow> rows);
std::optional<CellRate> WorstCell(std::span<const CellRate> cells);

// The mean over the rows' rates, each row counting the same: the thesis's "mean of the 60 cells".
double MeanOfRows(std::span<const ConfusionRow> rows);

// A rate for each cell that was seen, by elevation and azimuth.
std::vector<CellRate> RatesByCell(std::span<const Subject> subjects,
                                  std::span<const ShapeTrial> trials);
// The same with all azimuths of an elevation taken together (azimuth 0).
std::vector<CellRate> RatesByElevation(std::span<const CellRate> cells);

}  // namespace geon::evaluation
