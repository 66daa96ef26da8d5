#include "procs/geon/experiment_page.h"

#include "procs/geon/experiment_conditions.h"
#include "procs/geon/experiment_figures.h"
#include "procs/geon/experiment_rates.h"
#include "procs/geon/experiment_style.h"
#include "procs/geon/report_style.h"
#include "procs/geon/svg.h"
#include "procs/geon/verdict_text.h"

namespace geon::cli {
namespace {

using evaluation::CellRate;
using evaluation::ConfusionRow;
using evaluation::Reliability;
using evaluation::SuccessRate;

// What the figures are drawn from.
struct Findings {
  std::vector<ConfusionRow> rows;
  std::vector<CellRate> cells;
  Reliability reliability;
  SuccessRate all;
};

Findings FindingsOf(const ShapeRecord& record) {
  Findings findings;
  findings.rows = evaluation::CountAnswers(record.subjects, record.trials);
  findings.cells = evaluation::RatesByCell(record.subjects, record.trials);
  findings.reliability =
      evaluation::MeasureReliability(evaluation::PredictionsOf(record.subjects, record.trials));
  findings.all = evaluation::OverallRate(findings.rows);
  return findings;
}

std::string Percent(double share_1, int decimals = 1) {
  return Fixed(100.0 * share_1, decimals) + " %";
}

std::string Facts(const Findings& found) {
  const Reliability& reliability = found.reliability;
  std::string html =
      "<div class=\"facts\">" + Fact(std::to_string(found.all.n - found.all.right),
                                     "wrong of " + std::to_string(found.all.n) + " views");
  if (const auto label = evaluation::WorstClass(found.rows)) {
    const SuccessRate rate = evaluation::RatesByClass(found.rows)[static_cast<size_t>(*label)];
    html += Fact(Percent(rate.value_1()), "right in the worst class, " + PlainName(*label));
  }
  if (const auto row = evaluation::WorstRow(found.rows)) {
    html += Fact(Percent(row->rate().value_1()),
                 "right of the worst object: " + PlainName(row->subject.truth) + " " +
                     Escape(row->subject.object) + ", position " +
                     std::to_string(row->subject.position));
  }
  if (const auto cell = evaluation::WorstCell(found.cells)) {
    html += Fact(Percent(cell->rate.value_1()),
                 "right from the worst view: elevation " +
                     std::to_string(WholeDegrees(cell->cell.elevation_rad)) + "°, azimuth " +
                     std::to_string(WholeDegrees(cell->cell.azimuth_rad)) + "°");
  }
  html += Fact(Percent(reliability.decided_share().value_1()), "of the views were decided") +
          Fact(reliability.decided.n > 0 ? Percent(reliability.decided.value_1()) : "–",
               "of the decided ones are right") +
          Fact(Percent(reliability.expected_calibration_error_1, 2), "expected calibration error");
  return html + "</div>";
}

std::string Headline(const ShapeRecord& record, const Findings& found) {
  const evaluation::Interval interval = evaluation::WilsonInterval(found.all);
  return "<h1>" + Percent(found.all.value_1()) + " of " + std::to_string(found.all.n) +
         " views named rightly</h1><p class=\"lead\">95 % interval: " +
         Fixed(100.0 * interval.low_1, 1) + " to " + Percent(interval.high_1) + ". Method “" +
         Escape(record.method) + "”, simulated scans of six laser stripes each. " +
         Escape(ConditionsInWords(record)) + "</p><p class=\"muted\">Seed " +
         std::to_string(record.seed) + ", build " + Escape(record.git) + ".</p>";
}

constexpr const char* kGuide =
    "<p class=\"guide\"><b>How to read this page.</b> In every trial a camera looks at one object "
    "from one side, six laser stripes are measured on it, and the recogniser says which of seven "
    "shapes it is and how confident it is. <b style=\"color:#2171b5\">Blue</b> is right, <b "
    "style=\"color:#a63603\">orange</b> is wrong, darker is more, grey is none. Rest the mouse on "
    "a cell for its counts. A rate stands with its 95&nbsp;% interval (Wilson): an experiment like "
    "this one, repeated with other noise, would mostly end up in there. An answer is "
    "<i>decided</i> when the recogniser stands by it; the others are guesses that a robot had "
    "better not act on.</p>";

std::string ReliabilitySection(const Reliability& reliability) {
  return "<h2>Is the confidence to be believed?</h2><div class=\"two\">" +
         ReliabilityFigure(reliability) + "<div><p>The <b>expected calibration error</b> is <b>" +
         Percent(reliability.expected_calibration_error_1, 2) +
         "</b>: so far, on average, is the confidence from the rate of right answers (15 bins of "
         "equal width, each weighed by its answers; Guo et al. 2017). At 0 %, of all answers given "
         "with 90 % confidence nine in ten are right.</p><h3 style=\"margin-top:22px\">Decided and "
         "undecided answers</h3>" +
         DecidedTable(reliability) + "</div></div>";
}

std::string WorstSection(const ShapeRecord& record, const Findings& found) {
  const int wrong = found.all.n - found.all.right;
  std::string html = "<h2>The worst views</h2><p>";
  if (record.worst.empty()) {
    return html +
           "This record keeps no views to draw; run the experiment again with this build.</p>";
  }
  const std::string shown = std::to_string(record.worst.size());
  if (wrong == 0) {
    html +=
        "Nothing is wrong. These are the " + shown + " right answers with the least confidence.";
  } else if (static_cast<size_t>(wrong) == record.worst.size()) {
    html += wrong == 1 ? "The only wrong answer."
                       : "All " + shown + " wrong answers, the most confident first.";
  } else {
    html += "The " + shown + " most confident of " + std::to_string(wrong) +
            " wrong answers: where a robot would be misled most.";
  }
  return html +
         " On the left the six stripes together, seen from the right of the camera and above it; "
         "beside them each by itself, all to one scale: horizontal ones from above with the camera "
         "below, vertical ones from the side with the camera on the left. Only points taken for "
         "the target are drawn.</p><p class=\"legend\"><span class=\"key line-key horizontal\" "
         "style=\"margin-left:0\"></span>horizontal stripes<span class=\"key line-key "
         "vertical\"></span>vertical stripes</p>" +
         WorstViewFigures(ShownViews(record));
}

std::string Body(const ShapeRecord& record, const Findings& found) {
  const bool beside_thesis = AreThesisObjects(record);
  const std::string thesis =
      beside_thesis ? " In brackets what the thesis measured (tables 6.1–6.7)." : "";
  return Headline(record, found) + Facts(found) + kGuide +
         "<h2>What was taken for what</h2><p class=\"muted\">Each row is a true shape, each column "
         "an answer; percent of the row's views." +
         thesis + "</p>" + ClassFigure(found.rows, beside_thesis) +
         "<h2>From where it goes wrong</h2><p class=\"muted\">Error in each cell of the viewing "
         "sphere, over all objects." +
         (beside_thesis ? " The thesis found 3 to 30 % (figure 6.11)." : "") + "</p>" +
         SphereFigure(found.cells) + ReliabilitySection(found.reliability) +
         WorstSection(record, found) +
         "<h2>Every object in every position</h2><p class=\"muted\">Percent of the row's views, by "
         "answer." +
         thesis + "</p>" + RowFigures(found.rows, beside_thesis) +
         "<footer>Written by geon experiment. results.json beside this page holds every figure and "
         "every trial.</footer>";
}

}  // namespace

std::string ExperimentPage(const ShapeRecord& record) {
  const std::string body = record.trials.empty()
                               ? "<h1>No trials</h1><p>This part of the experiment holds none.</p>"
                               : Body(record, FindingsOf(record));
  return std::string(
             "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta "
             "name=\"viewport\" content=\"width=device-width\"><title>geonbot experiment: "
             "shapes</title><style>") +
         kReportStyle + kExperimentStyle + "</style></head><body><main>" + body +
         "</main></body></html>\n";
}

}  // namespace geon::cli
