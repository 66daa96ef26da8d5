#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "evaluation/confusion.h"
#include "evaluation/reliability.h"
#include "procs/geon/experiment_record.h"

namespace geon::cli {

// The figures of an experiment's report (experiment_page.h), each a piece of HTML.

// Truth by answer: seven by seven, in percent of the truth's views. With `beside_thesis` the
// thesis's own figures stand below (tables 6.1-6.7).
std::string ClassFigure(std::span<const evaluation::ConfusionRow> rows, bool beside_thesis);

// Every object in every position by answer, a block for each geon.
std::string RowFigures(std::span<const evaluation::ConfusionRow> rows, bool beside_thesis);

// The error over the viewing sphere: elevation by azimuth (thesis figure 6.11).
std::string SphereFigure(std::span<const evaluation::CellRate> cells);

// Success against confidence, and how many answers were given with which confidence.
std::string ReliabilityFigure(const evaluation::Reliability& reliability);

// How many were decided, and how many of these were right: a table.
std::string DecidedTable(const evaluation::Reliability& reliability);

// A view to be shown, with what was true and said of it. No answer: none was given.
struct ShownView {
  const WorstView* view;
  GeonLabel truth;
  std::optional<GeonLabel> answer;
  double confidence_1;
  bool decided;
  std::string where;  // which object and from where, for people
};

// A card for each: the picture if there is one, its stripes, its answer and the evidence.
std::string WorstViewFigures(std::span<const ShownView> views);

// The worst views of a record.
std::vector<ShownView> ShownViews(const ShapeRecord& record);

// "87.2 % (95 %: 86.5–87.9)".
std::string PercentWithInterval(const evaluation::SuccessRate& rate);

}  // namespace geon::cli
