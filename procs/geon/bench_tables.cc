#include <algorithm>
#include <cstdio>

#include "evaluation/thesis_results.h"
#include "procs/geon/bench_record.h"

namespace geon::cli {
namespace {

// The order of tables 6.8-6.10.
constexpr std::array<GeonLabel, kGeonLabelCount> kBenchColumns = {
    GeonLabel::kBentCuboid,      GeonLabel::kBentCylinder, GeonLabel::kTaperedCuboid,
    GeonLabel::kTaperedCylinder, GeonLabel::kCuboid,       GeonLabel::kCylinder,
    GeonLabel::kEllipsoid};

template <typename... Values>
std::string BenchText(const char* format, Values... values) {
  char text[160];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

std::string RateText(const evaluation::SuccessRate& rate) {
  const evaluation::Interval interval = evaluation::WilsonInterval(rate);
  return BenchText("%.1f %% of %d (95 %%: %.1f-%.1f)", 100.0 * rate.value_1(), rate.n,
                   100.0 * interval.low_1, 100.0 * interval.high_1);
}

std::string TableRow(const BenchRange& range, size_t r) {
  const evaluation::ConfusionRow& row = range.rows[r];
  const int n = row.n() + range.unanswered[r];
  const auto thesis = evaluation::ThesisBenchRow(range.range_m, row.subject.truth);
  std::string text = BenchText("%-17s", std::string(ToString(row.subject.truth)).c_str());
  for (const GeonLabel column : kBenchColumns) {
    const auto at = static_cast<size_t>(column);
    text += BenchText("%6.0f", 100.0 * row.counts[at] / n);
    text += BenchText("%6s", thesis ? BenchText("(%d)", (*thesis)[at]).c_str() : "");
  }
  return text + BenchText("%7d%6d\n", range.unanswered[r], n);
}

std::string RangeTable(const BenchRange& range) {
  std::string text =
      BenchText("\nAt %.2f m: answers in %%, the thesis's in brackets\n%-17s", range.range_m, "");
  for (const char* name : {"BCub", "BCyl", "TCub", "TCyl", "Cub", "Cyl", "Ell"}) {
    text += BenchText("%12s", name);
  }
  text += "   none     n\n";
  for (const GeonLabel truth : kBenchColumns) {
    for (size_t r = 0; r < range.rows.size(); ++r) {
      if (range.rows[r].subject.truth == truth) text += TableRow(range, r);
    }
  }
  double thesis_sum = 0.0;
  for (const GeonLabel truth : kBenchColumns) {
    const auto row = evaluation::ThesisBenchRow(range.range_m, truth);
    if (row) thesis_sum += (*row)[static_cast<size_t>(truth)];
  }
  text += "right: " + RateText(range.all);
  if (thesis_sum > 0.0) {
    text += BenchText(", the thesis %.1f %%", thesis_sum / static_cast<double>(kGeonLabelCount));
  }
  return text + "\n";
}

std::string SpreadText(const char* what, const std::optional<Spread>& spread, double unit,
                       const char* unit_name) {
  if (!spread) return "";
  return BenchText("%-44s median %.1f, 95 %% within %.1f, longest %.1f %s\n", what,
                   unit * spread->p50, unit * spread->p95, unit * spread->max, unit_name);
}

}  // namespace

std::string BenchTables(const BenchRecord& record) {
  if (record.trials.empty()) return "No trials.\n";
  std::string text;
  for (const BenchRange& range : BenchRanges(record)) text += RangeTable(range);
  text += "\n";
  text +=
      SpreadText("first sight to verdict, virtual time:", SpreadOf(SightTimes(record)), 1.0, "s");
  text += SpreadText("whole target in view to verdict:", SpreadOf(ViewTimes(record)), 1.0, "s");
  text += SpreadText("stripes beside their quarter:", SpreadOf(Misplacements(record)), 100.0,
                     "% of the target");
  return text;
}

}  // namespace geon::cli
