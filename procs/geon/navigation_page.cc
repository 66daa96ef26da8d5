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

// Every run of a course.
std::string Courses(const NavigationRecord& record) {
  std::string rows;
  for (const NavigationTrialRecord& trial : record.trials) {
    if (!trial.course) continue;
    rows += "<tr>" + Cell(Escape(trial.course->id)) + Cell(Escape(trial.world)) +
            Cell(std::string(ToString(trial.end))) + Cell(std::to_string(trial.contacts)) +
            Cell(Fixed(trial.hardest_contact_m_s, 2)) + Cell(Fixed(trial.end_s, 1)) +
            Cell(Fixed(trial.path_m, 2)) + Cell(Fixed(trial.course->shortest_m, 2)) +
            Cell(Fixed(trial.length_ratio_1(), 3)) + Cell(Fixed(trial.barn_score_1(), 3)) + "</tr>";
  }
  if (rows.empty()) return "";
  const NavigationSummary all = Summarize(record);
  const auto mean = [](const std::optional<double>& value) {
    return value ? Fixed(*value, 3) : "-";
  };
  return "<h2>Courses</h2><p>The way driven is " + mean(all.length_ratio_1) +
         " times the shortest for a disc of 0.267 m (mean of those that arrived; the last "
         "centimetres that were not driven are added); BARN's metric, which measures times by a "
         "robot of 2 m/s, is " +
         mean(all.barn_score_1) +
         " (mean of all).</p><table class=\"runs\"><tr><th>world</th><th>part</th><th>end</th>"
         "<th>contacts</th><th>at m/s</th><th>s</th><th>driven m</th><th>shortest m</th>"
         "<th>ratio</th><th>metric</th></tr>" +
         rows + "</table>";
}

std::string MapFigure(const DrawnRun& run, const NavigationTrialRecord& trial) {
  return "<figure>" + RunMap(run) + "<figcaption><b>Run " + std::to_string(trial.t) + ", " +
         Escape(trial.world) + (trial.course ? " " + Escape(trial.course->id) : "") + ", seed " +
         std::to_string(trial.seed) + "</b>: " + std::string(ToString(trial.end)) + " after " +
         Fixed(trial.end_s, 1) + " s, " + std::to_string(trial.contacts) +
         (trial.contacts == 1 ? " contact. " : " contacts. ") + Escape(trial.why) +
         "</figcaption></figure>";
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
  const std::string courses = Courses(record);
  return std::string(
             "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta "
             "name=\"viewport\" content=\"width=device-width\"><title>geonbot experiment: "
             "navigation</title><style>") +
         kReportStyle + kExperimentStyle + kDrawnRunStyle + "</style></head><body><main><h1>" +
         std::to_string(all.right) + " of " + std::to_string(all.runs) +
         " runs ended as they should</h1><p class=\"lead\">Planner “" + Escape(record.planner) +
         "”, sensors “" + Escape(record.conditions.value("sensors", "")) +
         "”. The simulated robot " +
         (courses.empty() ? "looks for a geon in a pen and drives to where it could scan it"
                          : "drives to a destination among cylinders") +
         ", in virtual time: the mission and the base's serial line as on the robot, pictures "
         "replaced "
         "by what they would show.</p><p class=\"muted\">Seed " +
         std::to_string(record.seed) + ", build " + Escape(record.git) + ". Times from the " +
         (courses.empty() ? "first sight to the place" : "start to the destination") + ".</p>" +
         Table(record) + "<h2>What went wrong</h2>" + Maps(record) + courses +
         "<footer>Written by geon experiment navigation. results.json beside this page holds every "
         "figure and every run.</footer></main></body></html>\n";
}

}  // namespace geon::cli
