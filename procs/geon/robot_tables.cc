#include <algorithm>

#include "evaluation/thesis_results.h"
#include "procs/geon/robot_record.h"
#include "procs/geon/spread.h"
#include "procs/geon/svg.h"

namespace geon::cli {
namespace {

using evaluation::SuccessRate;

std::string PercentOf(const SuccessRate& rate) {
  return Fixed(100.0 * rate.value_1(), 0) + " % of " + std::to_string(rate.n);
}

std::string ThesisCell(const std::string& place) {
  if (place == "floor") return PercentOf(evaluation::kThesisRunsOnFloor);
  if (place == "box") return PercentOf(evaluation::kThesisRunsOnBox);
  return PercentOf(evaluation::kThesisRuns);
}

std::string RightCell(const SuccessRate& right) {
  const evaluation::Interval interval = evaluation::WilsonInterval(right);
  return std::to_string(right.right) + ": " + Fixed(100.0 * right.value_1(), 1) + " % (" +
         Fixed(100.0 * interval.low_1, 1) + "-" + Fixed(100.0 * interval.high_1, 1) + ")";
}

std::vector<std::string> SummaryCells(const std::string& name, const RobotSummary& summary,
                                      const std::string& thesis) {
  const auto counted = [](int count, const std::string& more) {
    return std::to_string(count) + (count > 0 ? more : "");
  };
  std::vector<std::string> cells = {
      name,
      std::to_string(summary.right.n),
      RightCell(summary.right),
      thesis,
      std::to_string(summary.wrong),
      counted(summary.undecided, " (" + std::to_string(summary.right_guesses) + " right)"),
      std::to_string(summary.trapped),
      std::to_string(summary.unreachable),
      counted(summary.contacts, " (" + Fixed(summary.hardest_contact_m_s, 2) + " m/s)")};
  const auto spread = SpreadOf(summary.times_s);
  for (const auto value : {&Spread::p50, &Spread::p95, &Spread::max}) {
    cells.push_back(spread ? Fixed((*spread).*value, 1) : "");
  }
  return cells;
}

}  // namespace

std::vector<std::vector<std::string>> RobotTable(const RobotRecord& record) {
  std::vector<std::vector<std::string>> rows = {{"geon on", "runs", "right (95 %)", "thesis",
                                                 "wrong", "undecided", "trapped", "unreachable",
                                                 "contacts", "median s", "95 % s", "longest s"}};
  const std::vector<std::string> places = PlacesOf(record);
  for (const std::string& place : places) {
    rows.push_back(SummaryCells("the " + place, Summarize(record, place), ThesisCell(place)));
  }
  if (places.size() != 1) rows.push_back(SummaryCells("all", Summarize(record), ThesisCell("")));
  return rows;
}

std::string RobotNotes(const RobotRecord& record) {
  const RobotSummary all = Summarize(record);
  std::string text = "Views of the geon that the verdict rests on:";
  for (size_t k = 0; k < all.views.size(); ++k) {
    text += (k == 0 ? " " : ", ") + std::to_string(k + 1) + " in " + std::to_string(all.views[k]) +
            " runs";
  }
  if (all.views.empty()) text += " none";
  text += ". Geons found and rightly named: " + RightCell(all.geons) + " of " +
          std::to_string(all.geons.n) + "; " + std::to_string(all.others) +
          " findings where there is none";
  if (const auto off = SpreadOf(all.off_m)) {
    text += "; positions off by " + Fixed(off->p50, 3) + " m (median), " + Fixed(off->p95, 3) +
            " m (95 %), " + Fixed(off->max, 3) + " m at most";
  }
  return text + ".";
}

std::string RobotTables(const RobotRecord& record) {
  const std::vector<std::vector<std::string>> rows = RobotTable(record);
  std::string text =
      "method " + record.method + ", planner " + record.conditions.value("planner", "") +
      ", scan " + record.conditions.value("scan", "") + "; times from the start to the verdict\n";
  for (const auto& row : rows) {
    for (size_t k = 0; k < row.size(); ++k) {
      size_t width = 0;
      for (const auto& each : rows) width = std::max(width, each[k].size());
      const std::string pad(width - row[k].size(), ' ');
      text += k == 0 ? row[k] + pad : "  " + pad + row[k];
    }
    text += "\n";
  }
  return text + RobotNotes(record) + "\n" + kThesisRunsNote + "\n";
}

}  // namespace geon::cli
