#include "procs/geon/experiment_rates.h"

#include <cmath>
#include <string>

#include "base/angles.h"
#include "evaluation/confusion.h"
#include "evaluation/reliability.h"

namespace geon::cli {
namespace {

using evaluation::CellRate;
using evaluation::ConfusionRow;
using evaluation::SuccessRate;
using nlohmann::json;

json RowsJson(std::span<const ConfusionRow> rows) {
  json list = json::array();
  for (const ConfusionRow& row : rows) {
    list.push_back(RateJson(row.rate()));
    list.back()["truth"] = ToString(row.subject.truth);
    list.back()["object"] = row.subject.object;
    list.back()["position"] = row.subject.position;
  }
  return list;
}

json ElevationsJson(std::span<const CellRate> cells) {
  json list = json::array();
  for (const CellRate& elevation : evaluation::RatesByElevation(cells)) {
    list.push_back(RateJson(elevation.rate));
    list.back()["elevation_deg"] = WholeDegrees(elevation.cell.elevation_rad);
  }
  return list;
}

json ViewsJson(std::span<const CellRate> cells) {
  json list = json::array();
  for (const CellRate& cell : cells) {
    list.push_back(RateJson(cell.rate));
    list.back()["elevation_deg"] = WholeDegrees(cell.cell.elevation_rad);
    list.back()["azimuth_deg"] = WholeDegrees(cell.cell.azimuth_rad);
  }
  return list;
}

json BinsJson(const evaluation::Reliability& reliability) {
  json list = json::array();
  for (const evaluation::ReliabilityBin& bin : reliability.bins) {
    json mean_confidence, rate;  // of nothing: null
    if (bin.rate.n > 0) {
      mean_confidence = bin.mean_confidence_1;
      rate = bin.rate.value_1();
    }
    list.push_back({{"low", bin.low_1},
                    {"high", bin.high_1},
                    {"right", bin.rate.right},
                    {"n", bin.rate.n},
                    {"mean_confidence", mean_confidence},
                    {"rate", rate}});
  }
  return list;
}

}  // namespace

json RateJson(const SuccessRate& rate, const char* counted) {
  const evaluation::Interval interval = evaluation::WilsonInterval(rate);
  return {{counted, rate.right},
          {"n", rate.n},
          {"rate", rate.value_1()},
          {"wilson95", {interval.low_1, interval.high_1}}};
}

int WholeDegrees(double angle_rad) {
  return static_cast<int>(std::lround(DegreesFromRadians(angle_rad)));
}

json RatesJson(std::span<const evaluation::Subject> subjects,
               std::span<const evaluation::ShapeTrial> trials) {
  const std::vector<ConfusionRow> rows = evaluation::CountAnswers(subjects, trials);
  const std::vector<CellRate> cells = evaluation::RatesByCell(subjects, trials);
  const evaluation::Reliability reliability =
      evaluation::MeasureReliability(evaluation::PredictionsOf(subjects, trials));
  json rates = {{"all", RateJson(evaluation::OverallRate(rows))},
                {"mean_of_cells", evaluation::MeanOfRows(rows)},
                {"rows", RowsJson(rows)},
                {"elevations", ElevationsJson(cells)},
                {"views", ViewsJson(cells)},
                {"decided", RateJson(reliability.decided_share(), "decided")},
                {"decided_right", RateJson(reliability.decided)},
                {"expected_calibration_error", reliability.expected_calibration_error_1},
                {"reliability", BinsJson(reliability)}};
  const auto classes = evaluation::RatesByClass(rows);
  for (size_t k = 0; k < classes.size(); ++k) {
    if (classes[k].n > 0) rates["classes"][std::string(kGeonLabelNames[k])] = RateJson(classes[k]);
  }
  return rates;
}

}  // namespace geon::cli
