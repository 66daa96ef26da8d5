#include "procs/geon/experiment_color_page.h"

#include <algorithm>

#include "base/plain_name.h"
#include "procs/geon/experiment_style.h"
#include "procs/geon/report_style.h"
#include "procs/geon/svg.h"

namespace geon::cli {
namespace {

std::string Percent(double share_1) { return Fixed(100.0 * share_1, 1) + " %"; }

std::string Headline(const ColorRecord& record, const ColorRow& all) {
  const evaluation::Interval interval = evaluation::WilsonInterval(all.found.front());
  std::string html =
      "<h1>Target found in " + Percent(all.found.front().value_1()) + " of " +
      std::to_string(all.found.front().n) +
      " pictures</h1><p class=\"lead\">95 % interval: " + Fixed(100.0 * interval.low_1, 1) +
      " to " + Percent(interval.high_1) + ". Colour “" + Escape(record.methods.front()) +
      "”, median overlap (IoU) with the true mask " + Fixed(all.median_iou_1.front(), 3) +
      ".</p><p class=\"muted\">Seed " + std::to_string(record.seed) + ", build " +
      Escape(record.git) + ".</p><div class=\"facts\">";
  for (size_t method = 1; method < record.methods.size(); ++method) {
    html += Fact(Percent(all.found[method].value_1()), Escape(record.methods[method]));
  }
  return html + "</div>";
}

constexpr const char* kGuide =
    "<p class=\"guide\"><b>How to read this page.</b> Every picture is a rendered room with one "
    "red "
    "geon, seen by the robot's colour camera with its noise and blur, its white balance locked. "
    "The "
    "lamp's colour, the level of the light, sun, shadow and gloss vary, and other red-ish things "
    "stand by. The target is <i>found</i> when the centre of the chosen blob lies on the geon; the "
    "<i>overlap</i> is the share of the pixels in both masks among those in either. Pictures are "
    "exposed for the target by the exposure law, given six earlier frames of the scene; "
    "<i>fixed</i> is the camera's usual exposure.</p>";

std::string Table(const ColorRecord& record) {
  std::string html = "<table><tr><th></th>";
  for (const std::string& method : record.methods) {
    html += "<th class=\"number\">" + Escape(method) + "</th>";
  }
  html += "</tr>";
  for (const auto& [heading, rows] : ColorRows(record)) {
    if (!heading.empty()) {
      html += "<tr><th colspan=\"" + std::to_string(record.methods.size() + 1) + "\">" +
              Escape(heading) + "</th></tr>";
    }
    for (const ColorRow& row : rows) {
      html += "<tr><td>" + Escape(row.name) + "</td>";
      for (size_t method = 0; method < record.methods.size(); ++method) {
        const evaluation::SuccessRate& found = row.found[method];
        html += "<td class=\"number\" title=\"" + std::to_string(found.right) + " of " +
                std::to_string(found.n) + "\">" + Percent(found.value_1()) +
                " <span class=\"muted\">" + Fixed(row.median_iou_1[method], 2) + "</span></td>";
      }
      html += "</tr>";
    }
  }
  return html + "</table>";
}

std::string Caption(const ColorRecord& record, const WorstPicture& picture) {
  const auto outcome = std::find_if(record.outcomes.begin(), record.outcomes.end(),
                                    [&](const ColorOutcome& each) { return each.t == picture.t; });
  std::string caption = "trial " + std::to_string(picture.t);
  if (outcome != record.outcomes.end()) {
    caption += ": " + PlainName(outcome->label) + ", " + std::to_string(outcome->kelvin) + " K, " +
               std::to_string(outcome->stops) + " EV, " + outcome->light +
               (outcome->distractors ? ", red-ish things" : "") + ", exposure x " +
               Fixed(outcome->exposure_1, 2);
  }
  return (picture.score.found ? "found, " : "not found, ") + caption + "; overlap " +
         Fixed(picture.score.iou_1, 2);
}

std::string Pictures(const ColorRecord& record) {
  std::string html =
      "<h2>The worst pictures</h2><p class=\"muted\">As “" + Escape(record.methods.front()) +
      "” saw them: the true outline is green, the found one yellow.</p><div class=\"stripes\">";
  for (const WorstPicture& picture : record.worst) {
    const std::string caption = Escape(Caption(record, picture));
    html += "<figure class=\"card\"><img style=\"width:100%\" alt=\"" + caption + "\" src=\"" +
            Escape(picture.data_uri) + "\"><figcaption>" + caption + "</figcaption></figure>";
  }
  return html + "</div>";
}

std::string Body(const ColorRecord& record) {
  return Headline(record, ColorRows(record).front().second.front()) + kGuide +
         "<h2>By light and surroundings</h2><p class=\"muted\">Target found, and median "
         "overlap.</p>" +
         Table(record) + Pictures(record) + "<h2>The colour</h2><pre>" + Escape(record.model) +
         "</pre><footer>Written by geon experiment. results.json beside this page holds every "
         "figure and every trial.</footer>";
}

}  // namespace

std::string ColorPage(const ColorRecord& record) {
  const std::string body = record.outcomes.empty()
                               ? "<h1>No trials</h1><p>This part of the experiment holds none.</p>"
                               : Body(record);
  return std::string(
             "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta "
             "name=\"viewport\" content=\"width=device-width\"><title>geonbot experiment: "
             "color</title><style>") +
         kReportStyle + kExperimentStyle + "</style></head><body><main>" + body +
         "</main></body></html>\n";
}

}  // namespace geon::cli
