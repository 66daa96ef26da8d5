#include <algorithm>

#include "procs/geon/bench_record.h"
#include "procs/geon/experiment_style.h"
#include "procs/geon/navigation_record.h"
#include "procs/geon/report_style.h"
#include "procs/geon/svg.h"

namespace geon::cli {
namespace {

constexpr const char* kMapStyle = R"css(
.maps{display:grid;grid-template-columns:repeat(auto-fill,minmax(250px,1fr));gap:16px}
.maps figure{margin:0}.maps figcaption{font-size:13px;line-height:1.35}
.pen{fill:#f7f8f8;stroke:#5d666d;stroke-width:2}.thing{fill:#b9c3cc;stroke:#5d666d;stroke-width:1}
.way{fill:none;stroke:var(--accent);stroke-width:1.6}.start{fill:none;stroke:var(--accent);stroke-width:1.2}
.stand{fill:none;stroke:var(--second);stroke-width:2}.geon{fill:#96281b}
table.runs{border-collapse:collapse}table.runs th,table.runs td{padding:3px 10px;text-align:right}
table.runs th:first-child,table.runs td:first-child{text-align:left}
)css";

std::string Cell(const std::string& text) { return "<td>" + text + "</td>"; }

std::string TableRow(const std::string& name, const NavigationSummary& summary) {
  const auto spread = SpreadOf(summary.times_s);
  std::string row = "<tr>" + Cell(Escape(name)) + Cell(std::to_string(summary.runs)) +
                    Cell(std::to_string(summary.right)) + Cell(std::to_string(summary.reached)) +
                    Cell(std::to_string(summary.unreachable)) +
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
      "<th>unreachable</th><th>trapped</th><th>contacts</th><th>at m/s</th>"
      "<th>median s</th><th>95 % s</th><th>longest s</th></tr>";
  for (const std::string& world : WorldsOf(record)) {
    html += TableRow(world, Summarize(record, world));
  }
  return html + TableRow("all", Summarize(record)) + "</table>";
}

std::string MapFigure(const NavigationMap& map, const NavigationTrialRecord& trial) {
  constexpr double kWidth_px = 260.0;
  constexpr double kRobot_m = 0.267;
  const double height_px = kWidth_px * map.pen_m.y() / map.pen_m.x() + 8.0;
  const Eigen::Vector2d edge_m(0.05, 0.05);
  Plot plot(kWidth_px, height_px, -edge_m, map.pen_m + edge_m, true);
  plot.Polygon({{0.0, 0.0}, {map.pen_m.x(), 0.0}, map.pen_m, {0.0, map.pen_m.y()}}, "pen");
  for (const auto& outline_m : map.outlines_m) plot.Polygon(outline_m, "thing");
  plot.Polyline(map.path_m, "way");
  if (!map.path_m.empty()) {
    plot.Circle(map.path_m.front(), kRobot_m, "start");
    plot.Circle(map.path_m.back(), kRobot_m, "stand");
  }
  if (map.geon_m) plot.Circle(*map.geon_m, 0.08, "geon");
  return "<figure>" + plot.Svg("Map of run " + std::to_string(trial.t)) + "<figcaption><b>Run " +
         std::to_string(trial.t) + ", " + Escape(trial.world) + ", seed " +
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
  for (const NavigationMap& map : record.maps) {
    const auto trial = std::find_if(record.trials.begin(), record.trials.end(),
                                    [&](const auto& each) { return each.t == map.t; });
    if (trial != record.trials.end()) html += MapFigure(map, *trial);
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
         kReportStyle + kExperimentStyle + kMapStyle + "</style></head><body><main><h1>" +
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
