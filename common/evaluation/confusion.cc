#include "evaluation/confusion.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace geon::evaluation {

int ConfusionRow::n() const { return std::accumulate(counts.begin(), counts.end(), 0); }

SuccessRate ConfusionRow::rate() const { return {counts[static_cast<size_t>(subject.truth)], n()}; }

std::vector<ConfusionRow> CountAnswers(std::span<const Subject> subjects,
                                       std::span<const ShapeTrial> trials) {
  std::vector<ConfusionRow> all;
  for (const Subject& subject : subjects) all.push_back({subject, {}, 0});
  for (const ShapeTrial& trial : trials) {
    ConfusionRow& row = all[static_cast<size_t>(trial.subject)];
    ++row.counts[static_cast<size_t>(trial.answer)];
    if (!trial.decided) ++row.undecided;
  }
  std::erase_if(all, [](const ConfusionRow& row) { return row.n() == 0; });
  return all;
}

SuccessRate OverallRate(std::span<const ConfusionRow> rows) {
  SuccessRate all;
  for (const ConfusionRow& row : rows) {
    all.right += row.rate().right;
    all.n += row.rate().n;
  }
  return all;
}

std::array<SuccessRate, kGeonLabelCount> RatesByClass(std::span<const ConfusionRow> rows) {
  std::array<SuccessRate, kGeonLabelCount> classes{};
  for (const ConfusionRow& row : rows) {
    SuccessRate& rate = classes[static_cast<size_t>(row.subject.truth)];
    rate.right += row.rate().right;
    rate.n += row.rate().n;
  }
  return classes;
}

std::optional<GeonLabel> WorstClass(std::span<const ConfusionRow> rows) {
  const auto classes = RatesByClass(rows);
  std::optional<GeonLabel> worst;
  double lowest_1 = 2.0;
  for (size_t k = 0; k < classes.size(); ++k) {
    if (classes[k].n == 0 || classes[k].value_1() >= lowest_1) continue;
    worst = static_cast<GeonLabel>(k);
    lowest_1 = classes[k].value_1();
  }
  return worst;
}

std::optional<ConfusionRow> WorstRow(std::span<const ConfusionRow> rows) {
  const auto worst =
      std::min_element(rows.begin(), rows.end(), [](const ConfusionRow& a, const ConfusionRow& b) {
        return a.rate().value_1() < b.rate().value_1();
      });
  return worst == rows.end() ? std::nullopt : std::optional(*worst);
}

std::optional<CellRate> WorstCell(std::span<const CellRate> cells) {
  const auto worst = std::min_element(
      cells.begin(), cells.end(),
      [](const CellRate& a, const CellRate& b) { return a.rate.value_1() < b.rate.value_1(); });
  return worst == cells.end() ? std::nullopt : std::optional(*worst);
}

double MeanOfRows(std::span<const ConfusionRow> rows) {
  double sum = 0.0;
  for (const ConfusionRow& row : rows) sum += row.rate().value_1();
  return rows.empty() ? 0.0 : sum / static_cast<double>(rows.size());
}

std::vector<CellRate> RatesByCell(std::span<const Subject> subjects,
                                  std::span<const ShapeTrial> trials) {
  std::map<std::pair<double, double>, SuccessRate> rates;
  for (const ShapeTrial& trial : trials) {
    rates[{trial.cell.elevation_rad, trial.cell.azimuth_rad}].Count(
        trial.answer == subjects[static_cast<size_t>(trial.subject)].truth);
  }
  std::vector<CellRate> cells;
  for (const auto& [place, rate] : rates) cells.push_back({{place.first, place.second}, rate});
  return cells;
}

std::vector<CellRate> RatesByElevation(std::span<const CellRate> cells) {
  std::vector<CellRate> elevations;
  for (const CellRate& cell : cells) {
    if (elevations.empty() || elevations.back().cell.elevation_rad != cell.cell.elevation_rad) {
      elevations.push_back({{cell.cell.elevation_rad, 0.0}, {}});
    }
    elevations.back().rate.right += cell.rate.right;
    elevations.back().rate.n += cell.rate.n;
  }
  return elevations;
}

}  // namespace geon::evaluation
