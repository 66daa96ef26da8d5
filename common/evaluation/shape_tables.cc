#include "evaluation/shape_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/angles.h"
#include "evaluation/thesis_results.h"

namespace geon::evaluation {
namespace {

constexpr std::array<const char*, kGeonLabelCount> kShortNames = {"Cub",  "Cyl",  "Ell", "TCub",
                                                                  "TCyl", "BCub", "BCyl"};

template <typename... Values>
std::string Format(const char* format, Values... values) {
  char text[160];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

std::string WithInterval(const SuccessRate& rate) {
  const Interval interval = WilsonInterval(rate);
  return Format("%5.1f %% of %d (95 %%: %.1f-%.1f)", 100.0 * rate.value_1(), rate.n,
                100.0 * interval.low_1, 100.0 * interval.high_1);
}

std::string Heading(int table, GeonLabel truth) {
  std::string text = Format("\nTable 6.%d  %s: answers in %%, the thesis's in brackets\n", table,
                            std::string(ToString(truth)).c_str());
  text += "object  position";
  for (GeonLabel column : kThesisColumns) {
    text += Format("%11s", kShortNames[static_cast<size_t>(column)]);
  }
  return text + "      n\n";
}

std::string RowText(const ConfusionRow& row) {
  std::string text = Format("%-10s %5d", row.subject.object.c_str(), row.subject.position);
  const auto thesis = ThesisRow(row.subject);
  for (size_t k = 0; k < kThesisColumns.size(); ++k) {
    const int count = row.counts[static_cast<size_t>(kThesisColumns[k])];
    text += Format("%6.0f", 100.0 * count / row.n());
    text += thesis ? Format("%5s", Format("(%d)", (*thesis)[k]).c_str()) : std::string(5, ' ');
  }
  return text + Format("%7d\n", row.n());
}

// Mean of the thesis's rates over the rows it has; negative when it has none.
double ThesisMean(std::span<const ConfusionRow> rows) {
  double sum = 0.0;
  int count = 0;
  for (const ConfusionRow& row : rows) {
    const auto thesis = ThesisRow(row.subject);
    if (!thesis) continue;
    const auto column = std::find(kThesisColumns.begin(), kThesisColumns.end(), row.subject.truth);
    sum += (*thesis)[static_cast<size_t>(column - kThesisColumns.begin())];
    ++count;
  }
  return count > 0 ? sum / count : -1.0;
}

std::string Summary(const std::string& name, std::span<const ConfusionRow> rows) {
  const double thesis = ThesisMean(rows);
  std::string text = Format("%-17s mean of rows %5.1f", name.c_str(), 100.0 * MeanOfRows(rows));
  text += thesis >= 0.0 ? Format(" (%.1f)", thesis) : std::string();
  return text + "   " + WithInterval(OverallRate(rows)) + "\n";
}

std::string ErrorByElevation(std::span<const CellRate> cells) {
  std::string text = "\nFigure 6.11  error by elevation, all azimuths\n";
  for (const CellRate& elevation : RatesByElevation(cells)) {
    const SuccessRate wrong{elevation.rate.n - elevation.rate.right, elevation.rate.n};
    text += Format("%4.0f deg  ", DegreesFromRadians(elevation.cell.elevation_rad)) +
            WithInterval(wrong) + "\n";
  }
  const auto by_rate = [](const CellRate& a, const CellRate& b) {
    return a.rate.value_1() < b.rate.value_1();
  };
  const auto [worst, best] = std::minmax_element(cells.begin(), cells.end(), by_rate);
  return text + Format("viewing cells: %.0f to %.0f %% error (%d to %d)\n",
                       100.0 - 100.0 * best->rate.value_1(), 100.0 - 100.0 * worst->rate.value_1(),
                       kThesisLowestError, kThesisHighestError);
}

std::string Worst(std::span<const ConfusionRow> rows, std::span<const CellRate> cells) {
  std::string text;
  if (const auto label = WorstClass(rows)) {
    text += "worst class: " + std::string(ToString(*label)) + ", right " +
            WithInterval(RatesByClass(rows)[static_cast<size_t>(*label)]) + "\n";
  }
  if (const auto row = WorstRow(rows)) {
    text += "worst row: " + std::string(ToString(row->subject.truth)) + ", object " +
            row->subject.object + ", position " + std::to_string(row->subject.position) +
            ", right " + WithInterval(row->rate()) + "\n";
  }
  if (const auto cell = WorstCell(cells)) {
    text += Format("worst view: elevation %.0f deg, azimuth %.0f deg, right ",
                   DegreesFromRadians(cell->cell.elevation_rad),
                   DegreesFromRadians(cell->cell.azimuth_rad)) +
            WithInterval(cell->rate) + "\n";
  }
  return text;
}

std::string Trust(const Reliability& reliability) {
  std::string text = "decided: " + WithInterval(reliability.decided_share()) + "\n";
  if (reliability.decided.n > 0) {
    text += "right among the decided: " + WithInterval(reliability.decided) + "\n";
  }
  return text + Format("expected calibration error: %.2f %%\n",
                       100.0 * reliability.expected_calibration_error_1);
}

}  // namespace

std::string ShapeTables(std::span<const ConfusionRow> rows, std::span<const CellRate> cells,
                        const Reliability& reliability) {
  if (rows.empty()) return "No trials.\n";
  std::string text, summary;
  int undecided = 0;
  for (size_t k = 0; k < kThesisColumns.size(); ++k) {
    std::vector<ConfusionRow> own;
    for (const ConfusionRow& row : rows) {
      if (row.subject.truth == kThesisColumns[k]) own.push_back(row);
    }
    if (own.empty()) continue;
    text += Heading(static_cast<int>(k) + 1, kThesisColumns[k]);
    for (const ConfusionRow& row : own) {
      text += RowText(row);
      undecided += row.undecided;
    }
    summary += Summary(std::string(ToString(kThesisColumns[k])), own);
  }
  text += "\n" + summary + Summary("all", rows);
  text += "undecided: " + std::to_string(undecided) + "\n";
  return text + ErrorByElevation(cells) + "\n" + Worst(rows, cells) + Trust(reliability);
}

}  // namespace geon::evaluation
