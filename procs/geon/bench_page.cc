#include "procs/geon/bench_page.h"

#include <algorithm>

#include "base/plain_name.h"
#include "evaluation/thesis_results.h"
#include "procs/geon/experiment_figures.h"
#include "procs/geon/experiment_style.h"
#include "procs/geon/report_style.h"
#include "procs/geon/svg.h"

namespace geon::cli {
namespace {

std::string BenchFacts(const BenchRecord& record) {
  std::string html = "<div class=\"facts\">";
  for (const BenchRange& range : BenchRanges(record)) {
    html +=
        Fact(Fixed(100.0 * range.all.value_1(), 1) + " %",
             "right of " + std::to_string(range.all.n) + " at " + Fixed(range.range_m, 2) + " m");
  }
  if (const auto spread = SpreadOf(SightTimes(record))) {
    html += Fact(Fixed(spread->p50, 1) + " s", "from first sight to the verdict (median)");
  }
  if (const auto spread = SpreadOf(ViewTimes(record))) {
    html += Fact(Fixed(spread->p50, 1) + " s", "from the whole target in view (median)");
  }
  if (const auto spread = SpreadOf(Misplacements(record))) {
    html += Fact(Fixed(100.0 * spread->p95, 1) + " %",
                 "of the target: 95 % of the stripes lie so near their quarter");
  }
  return html + "</div>";
}

std::string ThesisLine(const BenchRange& range) {
  std::string text;
  for (size_t k = 0; k < kGeonLabelCount; ++k) {
    const auto row = evaluation::ThesisBenchRow(range.range_m, static_cast<GeonLabel>(k));
    if (!row) return "";
    text += (text.empty() ? "" : ", ") + PlainName(static_cast<GeonLabel>(k)) + " " +
            std::to_string((*row)[k]);
  }
  return " The thesis, percent right: " + text + ".";
}

std::string RangeSection(const BenchRange& range) {
  int unanswered = 0;
  for (const int each : range.unanswered) unanswered += each;
  std::string html = "<h2>At " + Fixed(range.range_m, 2) + " m</h2><p class=\"muted\">" +
                     PercentWithInterval(range.all) + " named rightly";
  if (unanswered > 0) html += "; " + std::to_string(unanswered) + " runs gave no answer";
  return html + "." + ThesisLine(range) + "</p>" + ClassFigure(range.rows, false);
}

std::string WorstRuns(const BenchRecord& record) {
  std::vector<ShownView> shown;
  for (const WorstView& view : record.worst) {
    const auto trial = std::find_if(record.trials.begin(), record.trials.end(),
                                    [&](const BenchTrialRecord& each) { return each.t == view.t; });
    if (trial == record.trials.end()) continue;
    shown.push_back({&view, trial->subject.truth, trial->answer, trial->confidence, trial->decided,
                     "Object " + trial->subject.object + ", position " +
                         std::to_string(trial->subject.position) + ", turned by " +
                         Fixed(trial->yaw_deg, 0) + "°, at " + Fixed(trial->range_m, 2) +
                         " m; the mission said: " + trial->end});
  }
  return "<h2>What went wrong</h2><p>The wrong answers, the most confident first (at most " +
         std::to_string(kMostWorstViews) +
         "); where nothing is wrong, the right ones with the least confidence. The picture is the "
         "one that the stripes were placed by, the target outlined as it was segmented.</p>" +
         WorstViewFigures(shown);
}

// What was asked for, in words; conditions of records that others wrote may lack any of it.
std::string Conditions(const nlohmann::json& conditions) {
  const std::string meshes = conditions.value("meshes", "");
  const bool sweeps = conditions.value("scan", "stop") == "sweep";
  return std::to_string(conditions.value("poses", 0)) + " poses of each of " +
         (meshes.empty() ? "the 28 objects" : "the meshes of " + Escape(meshes)) +
         (sweeps ? ", stripes laid while the head turns" : ", the head stops for each stripe") +
         ", distances by calibration " + Escape(conditions.value("calibration", "unknown"));
}

std::string BenchBody(const BenchRecord& record) {
  evaluation::SuccessRate all;
  for (const BenchTrialRecord& trial : record.trials) all.Count(trial.right());
  std::string html =
      "<h1>" + Fixed(100.0 * all.value_1(), 1) + " % of " + std::to_string(all.n) +
      " geons on the bench named rightly</h1><p class=\"lead\">Method “" + Escape(record.method) +
      "”. Before a desk 70 cm high the simulated robot looks for the geon, centres it, lays six "
      "laser stripes and names it: rendered pictures, serial protocols and calibration included, "
      "in "
      "virtual time. Tables 6.8–6.10 of the thesis.</p><p class=\"muted\">Seed " +
      std::to_string(record.seed) + ", build " + Escape(record.git) + ", " +
      Conditions(record.conditions) + ".</p>" + BenchFacts(record);
  for (const BenchRange& range : BenchRanges(record)) html += RangeSection(range);
  return html + WorstRuns(record) +
         "<footer>Written by geon experiment bench. results.json beside this page holds every "
         "figure and every trial.</footer>";
}

}  // namespace

std::string BenchPage(const BenchRecord& record) {
  const std::string body = record.trials.empty()
                               ? "<h1>No trials</h1><p>This part of the experiment holds none.</p>"
                               : BenchBody(record);
  return std::string(
             "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta "
             "name=\"viewport\" content=\"width=device-width\"><title>geonbot experiment: "
             "bench</title><style>") +
         kReportStyle + kExperimentStyle + "</style></head><body><main>" + body +
         "</main></body></html>\n";
}

}  // namespace geon::cli
