#include "procs/geon/report_page.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "base/angles.h"
#include "procs/geon/report_figures.h"
#include "procs/geon/report_style.h"
#include "procs/geon/svg.h"
#include "procs/geon/verdict_text.h"

namespace geon::cli {
namespace {

constexpr size_t kEarlierViews = 4;

double DrivenMetres(const RunRecord& run) {
  double driven_m = 0.0;
  for (size_t i = 1; i < run.path.size(); ++i) {
    driven_m +=
        std::hypot(run.path[i].x_m - run.path[i - 1].x_m, run.path[i].y_m - run.path[i - 1].y_m);
  }
  return driven_m;
}

std::string DateTime(int64_t utime) {
  const std::time_t seconds = utime / 1000000;
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  char text[40];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S UTC", &parts);
  return text;
}

std::string Headline(const RunRecord& run, const std::optional<GeonLabel>& truth) {
  if (!run.verdict) {
    const std::string why = run.last_state ? run.last_state->text : "the planner said nothing";
    return "<h1>No geon was named</h1><p>" + Escape(why) + "</p>";
  }
  const sensor::GeonVerdict& verdict = *run.verdict;
  std::string html = "<h1>The geon is " + WithArticle(verdict.label) +
                     (verdict.decided ? "" : ", perhaps") + "</h1><p>";
  if (truth) {
    const bool right = *truth == verdict.label;
    html += std::string("<span class=\"badge ") + (right ? "right\">right" : "wrong\">wrong") +
            "</span> It really is " + WithArticle(*truth) + ". ";
  }
  return html + "Confidence " + Fixed(100.0 * verdict.confidence, 0) + " %, by the method “" +
         Escape(verdict.method) + "”" + (verdict.decided ? "" : "; no more than a guess") + ".</p>";
}

std::string Facts(const RunRecord& run) {
  const std::string planned = run.plan ? std::to_string(run.plan->stripes.size()) : "0";
  return "<div class=\"facts\">" +
         Fact(Fixed(run.duration_s, 0) + " s", "from first to last message") +
         Fact(Fixed(DrivenMetres(run), 1) + " m", "driven") +
         Fact(std::to_string(run.profiles.size()) + " of " + planned,
              "stripes measured, " + std::to_string(run.stripes_answered) + " laid") +
         Fact(std::to_string(run.contacts), "bumper contacts") +
         Fact(std::to_string(run.channels.lost()),
              "messages lost of " + std::to_string(run.events)) +
         "</div>";
}

std::string Notices(const RunRecord& run) {
  std::string html;
  if (run.damage.any()) {
    html += "<p class=\"notice\">The log is damaged: " + Escape(messaging::Describe(run.damage)) +
            ". This page shows what is whole.</p>";
  }
  if (run.channels.refused() > 0) {
    html += "<p class=\"notice\">" + std::to_string(run.channels.refused()) +
            " messages could not be decoded.</p>";
  }
  return html;
}

std::string ViewSection(const RunRecord& run) {
  if (run.views.empty()) return "<p class=\"muted\">No camera picture in the log.</p>";
  // The picture of the verdict's scan, else the last that shows a target, else the last.
  const sensor::TargetView* chosen = &run.views.back();
  for (const sensor::TargetView& view : run.views) {
    if (view.target_box) chosen = &view;
  }
  for (const sensor::TargetView& view : run.views) {
    if (run.plan && view.scan_id == run.plan->scan_id) chosen = &view;
  }
  std::string caption = "Head at pan " + Fixed(DegreesFromRadians(chosen->pan_rad), 1) +
                        "°, tilt " + Fixed(DegreesFromRadians(chosen->tilt_rad), 1) + "°. ";
  caption += chosen->target_box
                 ? "White: taken for the target (" + std::to_string(chosen->target_pixels) +
                       " pixels). Yellow: its box, where the stripes are placed."
                 : "No target was found here.";
  std::string html =
      "<figure class=\"card\">" + ViewFigure(*chosen) + "<figcaption>" + caption + "</figcaption>";
  std::string thumbs;
  size_t shown = 0;
  for (auto view = run.views.rbegin(); view != run.views.rend() && shown < kEarlierViews; ++view) {
    if (&*view == chosen) continue;
    thumbs = ViewFigure(*view) + thumbs;
    ++shown;
  }
  if (!thumbs.empty()) {
    html += "<div class=\"thumbs\">" + thumbs + "</div><figcaption>Earlier looks.</figcaption>";
  }
  return html + "</figure>";
}

std::string WhySection(const RunRecord& run) {
  if (!run.verdict) return "";
  std::string html = "<div><h3>Why</h3><ol class=\"reasons\">";
  for (const std::string& reason : run.verdict->reasons) html += "<li>" + Escape(reason) + "</li>";
  return html + "</ol><h3>How probable each shape is</h3>" + PosteriorFigure(*run.verdict) +
         "</div>";
}

const char* LevelName(sensor::HealthLevel level) {
  switch (level) {
    case sensor::HealthLevel::kStarting:
      return "starting";
    case sensor::HealthLevel::kOk:
      return "ok";
    case sensor::HealthLevel::kWarn:
      return "warn";
    case sensor::HealthLevel::kFault:
      return "fault";
  }
  return "";
}

std::string HealthSection(const RunRecord& run) {
  std::string html;
  if (run.health.empty()) html += "<p class=\"muted\">No process told its health.</p>";
  if (!run.health.empty()) {
    html +=
        "<table><thead><tr><th>process</th><th>worst</th><th>at the end</th><th class=\"number\">"
        "starts</th><th class=\"number\">reconnects</th><th class=\"number\">messages lost</th>"
        "<th class=\"number\">refused</th></tr></thead><tbody>";
    for (const auto& [name, process] : run.health) {
      const std::string worst = LevelName(process.worst);
      const std::string last = LevelName(process.last.level);
      html += "<tr><td>" + Escape(name) + "</td><td><span class=\"" + worst + "\">" + worst +
              "</span> " + Escape(process.worst_text) + "</td><td class=\"" + last + "\">" + last +
              "</td><td class=\"number\">" + std::to_string(process.starts) +
              "</td><td class=\"number\">" + std::to_string(process.last.reconnects) +
              "</td><td class=\"number\">" + std::to_string(process.last.rx_lost) +
              "</td><td class=\"number\">" + std::to_string(process.last.decode_errors) +
              "</td></tr>";
    }
    html += "</tbody></table>";
  }
  html +=
      "<h3 style=\"margin-top:20px\">Channels, as recorded</h3><table><thead><tr><th>channel</th>"
      "<th class=\"number\">messages</th><th class=\"number\">lost</th><th class=\"number\">kB</th>"
      "</tr></thead><tbody>";
  for (const auto& [name, channel] : run.channels.channels()) {
    html += "<tr><td>" + Escape(name) + "</td><td class=\"number\">" +
            std::to_string(channel.received) + "</td><td class=\"number" +
            (channel.lost > 0 ? " fault" : "") + "\">" + std::to_string(channel.lost) +
            "</td><td class=\"number\">" + std::to_string((channel.bytes + 512) / 1024) +
            "</td></tr>";
  }
  return html + "</tbody></table>";
}

std::string Footer(const RunRecord& run) {
  std::string html = "<footer>" + Escape(run.file) + ", recorded " + DateTime(run.first_utime);
  const auto recognizer = run.sessions.find("geon-recognizer");
  if (recognizer != run.sessions.end()) {
    html += "; geonbot " + Escape(recognizer->second.version) + ", configuration " +
            Escape(recognizer->second.config_hash) + ", calibration " +
            Escape(recognizer->second.calibration_hash);
  }
  return html + ".</footer>";
}

}  // namespace

std::optional<GeonLabel> TrueLabel(const RunRecord& run, const Truth& truth) {
  Eigen::Vector2d near_m = Eigen::Vector2d::Zero();
  if (!run.path.empty()) near_m = {run.path.back().x_m, run.path.back().y_m};
  if (run.last_state && run.last_state->p_WTarget_m) near_m = *run.last_state->p_WTarget_m;
  return truth.LabelNear(near_m.x(), near_m.y());
}

std::string ReportPage(const RunRecord& run, const geometry::SensorRig& rig,
                       const std::optional<Truth>& truth) {
  const std::optional<GeonLabel> true_label = truth ? TrueLabel(run, *truth) : std::nullopt;
  const std::string title = run.verdict ? PlainName(run.verdict->label) : "no verdict";
  return std::string(
             "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta "
             "name=\"viewport\" content=\"width=device-width\"><title>geonbot: ") +
         Escape(title) + "</title><style>" + kReportStyle + kReportDarkStyle +
         "</style></head><body><main>" + Headline(run, true_label) + Facts(run) + Notices(run) +
         "<h2>What the robot saw, and why it decided so</h2><div class=\"two\">" +
         ViewSection(run) + WhySection(run) +
         "</div><h2>The stripes</h2><p class=\"muted\">Horizontal stripes from above, vertical "
         "ones from "
         "the side; the camera is below, or to the left. Coloured points lie on the target. Below "
         "each: "
         "how sharply the profile turns (difference of slope), and the band within which it counts "
         "as "
         "straight.</p>" +
         StripeFigures(run, rig) + "<h2>The way there</h2><figure class=\"card\">" +
         MapFigure(run, truth) + "</figure><h2>What happened when</h2>" + TimelineFigure(run) +
         "<h2>Health and losses</h2>" + HealthSection(run) + Footer(run) +
         "</main></body></html>\n";
}

}  // namespace geon::cli
