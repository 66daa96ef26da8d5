#include <algorithm>

#include "procs/geon/experiment_figures.h"
#include "procs/geon/experiment_style.h"
#include "procs/geon/report_style.h"
#include "procs/geon/robot_record.h"
#include "procs/geon/svg.h"
#include "procs/geon/verdict_text.h"

namespace geon::cli {
namespace {

constexpr const char* kRobotStyle = R"css(
.film{display:grid;grid-template-columns:260px 1fr;gap:20px;align-items:start}
.strip{display:grid;grid-template-columns:repeat(auto-fill,minmax(140px,1fr));gap:14px}
.strip figure,.film>figure{margin:0}.strip img,.failed img{display:block;width:100%;border-radius:4px}
.strip .blank{aspect-ratio:4/3;border-radius:4px;background:var(--line)}
.strip figcaption{font-size:13px;line-height:1.35;margin-top:4px}.strip b{color:var(--ink)}
.failed{display:grid;grid-template-columns:repeat(auto-fill,minmax(480px,1fr));gap:16px}
.failed article{display:grid;grid-template-columns:180px 1fr;gap:4px 16px;align-items:start;
align-content:start}
.failed h3,.failed p{grid-column:1/-1;margin:0}.failed p{font-size:14px;line-height:1.35}
table.runs{font-size:13px}table.runs td{white-space:nowrap}
table.runs td,table.runs th{padding:3px 4px;vertical-align:bottom}
@media (max-width:760px){.film,.failed{grid-template-columns:1fr}}
)css";

std::string RunsTable(const RobotRecord& record) {
  std::string html = "<table class=\"runs\">";
  const char* cell = "th";
  for (const auto& row : RobotTable(record)) {
    html += "<tr>";
    for (const std::string& text : row) {
      html += "<" + std::string(cell) + ">" + Escape(text) + "</" + cell + ">";
    }
    html += "</tr>";
    cell = "td";
  }
  return html + "</table><p class=\"muted\">" + Escape(kThesisRunsNote) + "</p>";
}

// A survey has no label of its own: how many of the geons it named.
std::string SurveyEnding(const RobotTrialRecord& trial) {
  const auto right = std::count_if(trial.geons.begin(), trial.geons.end(),
                                   [](const RobotGeonRecord& geon) { return geon.right(); });
  return std::to_string(right) + " of " + std::to_string(trial.geons.size()) +
         " geons rightly named, " + std::to_string(trial.others) + " findings where there is none";
}

std::string Ending(const RobotTrialRecord& trial) {
  if (trial.surveyed()) return SurveyEnding(trial);
  std::string text = WithArticle(trial.subject.truth) + " on the " + trial.subject.object;
  if (trial.right()) return text + ", rightly named";
  if (trial.named()) return text + ", taken for " + WithArticle(*trial.label);
  if (trial.reached()) return text + ", perhaps " + WithArticle(*trial.label);
  return text + (trial.unreachable() ? ", said to be out of reach" : ", not named");
}

std::string RunHeading(const RobotTrialRecord& trial) {
  return "Run " + std::to_string(trial.t) + ", seed " + std::to_string(trial.seed) +
         (trial.world.empty() ? "" : ", " + trial.world) + ": " + Ending(trial);
}

const RobotTrialRecord* RunOf(const RobotRecord& record, int t) {
  const auto trial = std::find_if(record.trials.begin(), record.trials.end(),
                                  [t](const auto& each) { return each.t == t; });
  return trial == record.trials.end() ? nullptr : &*trial;
}

std::string StillFigure(size_t number, const RobotFilm::Still& still) {
  const std::string picture = still.picture_uri.empty() ? "<div class=\"blank\"></div>"
                                                        : "<img alt=\"what the head saw\" src=\"" +
                                                              still.picture_uri + "\"/>";
  return "<figure>" + picture + "<figcaption><b>" + std::to_string(number) + ". " +
         Escape(still.phase) + "</b> at " + Fixed(still.time_s, 1) + " s<br/>" +
         Escape(still.text) + "</figcaption></figure>";
}

std::string FilmSection(const RobotRecord& record) {
  if (!record.film) return "";
  std::vector<Eigen::Vector2d> stops_m;
  std::string strip;
  for (const RobotFilm::Still& still : record.film->stills) {
    stops_m.push_back(still.place_m);
    strip += StillFigure(stops_m.size(), still);
  }
  std::string html = "<h2>One run, from search to verdict</h2>";
  if (const RobotTrialRecord* trial = RunOf(record, record.film->run.t)) {
    html += "<p>" + Escape(RunHeading(*trial)) + ", after " + Fixed(trial->end_s, 1) +
            " s. What the head's camera saw whenever the mission went over to another phase; the "
            "map shows where: from the thin circle to the thick one, the geon red.</p>";
  }
  return html + "<div class=\"film\"><figure>" + RunMap(record.film->run, stops_m) +
         "</figure><div class=\"strip\">" + strip + "</div></div>";
}

std::string ConfusionSection(const RobotRecord& record) {
  std::vector<evaluation::ConfusionRow> rows;
  int unanswered = 0;
  for (const RobotTrialRecord& trial : record.trials) {
    const auto count = [&](const evaluation::Subject& subject, std::optional<GeonLabel> label,
                           bool decided) {
      if (!label) {
        ++unanswered;
        return;
      }
      rows.push_back({subject, {}, decided ? 0 : 1});
      ++rows.back().counts[static_cast<size_t>(*label)];
    };
    if (!trial.surveyed()) count(trial.subject, trial.label, trial.decided);
    for (const RobotGeonRecord& geon : trial.geons) {
      if (trial.surveyed()) count({geon.truth, geon.place, 1}, geon.label, geon.decided);
    }
  }
  return "<h2>What was taken for what</h2><p class=\"muted\">All verdicts, the undecided ones as "
         "well; " +
         std::to_string(unanswered) + " geons have none.</p>" + ClassFigure(rows, false);
}

std::string FailedRun(const DrawnRun& run, const RobotTrialRecord& trial) {
  std::string html =
      "<article class=\"card\"><h3>" + Escape(RunHeading(trial)) + "</h3>" + RunMap(run);
  if (!run.picture_uri.empty()) {
    html += "<img alt=\"the picture of the last decision, the target outlined\" src=\"" +
            run.picture_uri + "\"/>";
  }
  return html + "<p>" + Fixed(trial.end_s, 1) + " s, " + Fixed(trial.path_m, 1) + " m driven, " +
         std::to_string(trial.contacts) + (trial.contacts == 1 ? " contact" : " contacts") +
         (trial.label ? ", confidence " + Fixed(100.0 * trial.confidence, 0) + " %" : "") +
         ". The mission said: " + Escape(trial.why) + "</p></article>";
}

std::string FailedRuns(const RobotRecord& record) {
  if (record.maps.empty()) return "<p>Nothing: every geon was named rightly.</p>";
  std::string html =
      "<p>Runs that did not name the geon rightly, at most the first " +
      std::to_string(kMostDrawnRuns) +
      ", each with the picture on which the last decision was taken; the white line is how the "
      "target was segmented.</p><div class=\"failed\">";
  for (const DrawnRun& run : record.maps) {
    if (const RobotTrialRecord* trial = RunOf(record, run.t)) html += FailedRun(run, *trial);
  }
  return html + "</div>";
}

std::string RobotBody(const RobotRecord& record) {
  const RobotSummary all = Summarize(record);
  const bool surveys = !record.trials.empty() && record.trials.front().surveyed();
  const bool sweeps = record.conditions.value("scan", "stop") == "sweep";
  return "<h1>" + std::to_string(all.right.right) + " of " + std::to_string(all.right.n) +
         " missions named " + (surveys ? "all their geons" : "the geon") +
         " rightly</h1><p class=\"lead\">Method “" + Escape(record.method) + "”, planner “" +
         Escape(record.conditions.value("planner", "")) +
         (sweeps ? "”, stripes laid while the head turns" : "”, the head stops for each stripe") +
         ". The simulated robot looks for a geon in a pen, drives up to it, scans and names it: "
         "rendered pictures, serial protocols and calibration included, in virtual time. Section "
         "6.3 of the thesis.</p><p class=\"muted\">Seed " +
         std::to_string(record.seed) + ", build " + Escape(record.git) +
         ", distances by calibration " + Escape(record.conditions.value("calibration", "unknown")) +
         ". Times are virtual, from the start to the verdict.</p>" + RunsTable(record) + "<p>" +
         Escape(RobotNotes(record)) + "</p>" + FilmSection(record) + ConfusionSection(record) +
         "<h2>What went wrong</h2>" + FailedRuns(record) +
         "<footer>Written by geon experiment robot. results.json beside this page holds every "
         "figure and every run.</footer>";
}

}  // namespace

std::string RobotPage(const RobotRecord& record) {
  const std::string body = record.trials.empty()
                               ? "<h1>No runs</h1><p>This part of the experiment holds none.</p>"
                               : RobotBody(record);
  return std::string(
             "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta "
             "name=\"viewport\" content=\"width=device-width\"><title>geonbot experiment: "
             "robot</title><style>") +
         kReportStyle + kExperimentStyle + kDrawnRunStyle + kRobotStyle +
         "</style></head><body><main>" + body + "</main></body></html>\n";
}

}  // namespace geon::cli
