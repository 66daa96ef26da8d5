#include <algorithm>

#include "procs/geon/experiment_style.h"
#include "procs/geon/navigation_record.h"
#include "procs/geon/report_style.h"
#include "procs/geon/spread.h"
#include "procs/geon/svg.h"

namespace geon::cli {
namespace {

std::string Cell(const std::string& text) { return "<td>" + text + "</td>"; }

std::string TableRow(const std::string& name, const NavigationSummary& summary) {
  const auto spread = SpreadOf(summary.times_s);
  std::string row = "<tr>" + Cell(Escape(name)) + Cell(std::to_string(summary.runs)) +
                    Cell(std::to_string(summary.right)) + Cell(std::to_string(summary.reached)) +
                    Cell(std::to_string(summary.unreachable)) +
                    Cell(std::to_string(summary.none_found)) +
                    Cell(std::to_string(summary.trapped)) + Cell(std::to_string(summary.contacts)) +
                    Cell(Fixed(summary.hardest_contact_m_s, 2));
  for (const auto value : {&Spread::p50, &Spread::p95, &Spread::max}) {
    row += Cell(spread ? Fixed((*spread).*value, 1) : "");
  }
  return row + "</tr>";
}

std::string Table(const NavigationRecord& record) {
  std::string html =
      "<table class=\"runs\"><tr><th>world</th><th>runs</th><th>right</th><th>reached</th>"
      "<th>unreachable</th><th>none found</th><th>trapped</th><th>contacts</th><th>at m/s</th>"
      "<th>median s</th><th>95 % s</th><th>longest s</th></tr>";
  for (const std::string& world : WorldsOf(record)) {
    html += TableRow(world, Summarize(record, world));
  }
  return html + TableRow("all", Summarize(record)) + "</table>";
}

std::string MapFigure(const DrawnRun& run, const NavigationTrialRecord& trial) {
  return "<figure>" + RunMap(run) + "<figcaption><b>Run " + std::to_string(trial.t) + ", " +
         Escape(trial.world) + ", seed " + std::to_string(trial.seed) +
         "</b>: " + std::string(ToString(trial.end)) + " after " + Fixed(trial.end_s, 1) + " s, " +
         std::to_string(trial.contacts) + (trial.contacts == 1 ? " contact. " : " contacts. ") +
         Escape(trial.why) + "</figcaption></figure>";
}

std::string Maps(const NavigationRecord& record) {
  if (record.maps.empty()) return "<p>No run went wrong.</p>";
  std::string html =
      "<p>The robot starts at the thin circle and ends at the thick one; the geon is red. The "
      "first " +
      std::to_string(record.maps.size()) + " runs that went wrong:</p><div class=\"maps\">";
  for (const DrawnRun& run : record.maps) {
    const auto trial = std::find_if(record.trials.begin(), record.trials.end(),
                                    [&](const auto& each) { return each.t == run.t; });
    if (trial != record.trials.end()) html += MapFigure(run, *trial);
  }
  return html + "</div>";
}

}  // namespace

std::string NavigationPage(const NavigationRecord& record) {
  const NavigationSummary all = Summarize(record);
  return std::string(
             "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta "
             "name=\"viewport\" content=\"width=device-width\"><title>geonbot experiment: "
             "navigation</title><style>") +
         kReportStyle + kExperimentStyle + kDrawnRunStyle + "</style></head><body><main><h1>" +
         std::to_string(all.right) + " of " + std::to_string(all.runs) +
         " runs ended as they should</h1><p class=\"lead\">Planner “" + Escape(record.planner) +
         "”, sensors “" + Escape(record.conditions.value("sensors", "")) +
         "”. The simulated robot looks for a geon in a pen and drives to where it could scan it, "
         "in "
         "virtual time: the mission and the base's serial line as on the robot, pictures replaced "
         "by what they would show.</p><p class=\"muted\">Seed " +
         std::to_string(record.seed) + ", build " + Escape(record.git) +
         ". Times from the first sight to the place.</p>" + Table(record) +
         "<h2>What went wrong</h2>" + Maps(record) +
         "<footer>Written by geon experiment navigation. results.json beside this page holds every "
         "figure and every run.</footer></main></body></html>\n";
}

}  // namespace geon::cli
