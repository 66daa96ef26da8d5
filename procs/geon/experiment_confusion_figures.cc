#include <algorithm>
#include <optional>

#include "evaluation/thesis_results.h"
#include "procs/geon/experiment_figures.h"
#include "procs/geon/heat_grid.h"
#include "procs/geon/svg.h"
#include "procs/geon/verdict_text.h"

namespace geon::cli {
namespace {

using evaluation::ConfusionRow;
using evaluation::Subject;
using Counts = std::array<int, kGeonLabelCount>;
using ThesisPercent = std::optional<std::array<double, kGeonLabelCount>>;

constexpr std::array<GeonLabel, kGeonLabelCount> kLabels = {
    GeonLabel::kCuboid,        GeonLabel::kCylinder,        GeonLabel::kEllipsoid,
    GeonLabel::kTaperedCuboid, GeonLabel::kTaperedCylinder, GeonLabel::kBentCuboid,
    GeonLabel::kBentCylinder};

// What stands in a cell, and how large.
struct CellStyle {
  int decimals = 0;
  std::string css = "cell";
  std::string anchor = "end";
  Eigen::Vector2d number_px{-4, 4};
  std::string thesis_anchor = "start";
  Eigen::Vector2d thesis_px{-1, 4};
  std::string thesis_css = "cell thesis";
};

std::vector<ConfusionRow> RowsOf(GeonLabel truth, std::span<const ConfusionRow> rows) {
  std::vector<ConfusionRow> own;
  for (const ConfusionRow& row : rows) {
    if (row.subject.truth == truth) own.push_back(row);
  }
  return own;
}

ThesisPercent ThesisOf(std::span<const ConfusionRow> rows) {
  std::vector<Subject> subjects;
  for (const ConfusionRow& row : rows) subjects.push_back(row.subject);
  return evaluation::ThesisMeanRow(subjects);
}

// One row of answers: blue where they are right, orange where they are wrong.
void DrawAnswers(size_t r, const std::string& name, GeonLabel truth, const Counts& counts, int n,
                 const ThesisPercent& thesis, const CellStyle& style, HeatGrid* grid) {
  for (size_t k = 0; k < kLabels.size(); ++k) {
    const double share_1 = n > 0 ? static_cast<double>(counts[k]) / n : 0.0;
    const HeatHue hue = kLabels[k] == truth ? HeatHue::kRight : HeatHue::kWrong;
    std::string title = name + " called " + PlainName(kLabels[k]) + ": " +
                        std::to_string(counts[k]) + " of " + std::to_string(n) + " views, " +
                        Fixed(100.0 * share_1, 1) + " %";
    if (thesis) title += "; thesis " + Fixed((*thesis)[k], 1) + " %";
    grid->Cell(r, k, hue, share_1, title);
    const bool told = counts[k] > 0 || kLabels[k] == truth;
    if (told) {
      grid->CellText(r, k, thesis ? style.number_px : Eigen::Vector2d(0, 4),
                     thesis ? style.anchor : "middle", style.css, share_1,
                     Fixed(100.0 * share_1, style.decimals));
    }
    if (thesis && (told || (*thesis)[k] > 0.0)) {
      grid->CellText(r, k, style.thesis_px, style.thesis_anchor, style.thesis_css, share_1,
                     "(" + Fixed((*thesis)[k], style.decimals) + ")");
    }
  }
}

void NameColumns(HeatGrid* grid) {
  for (size_t k = 0; k < kLabels.size(); ++k) grid->ColumnName(k, PlainName(kLabels[k]));
}

// Long names of meshes end in three points, between whole characters.
std::string Shortened(const std::string& name) {
  constexpr size_t kLongest = 22;
  if (name.size() <= kLongest) return name;
  size_t end = kLongest - 1;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) --end;
  return name.substr(0, end) + "…";
}

std::string RowTitle(const Subject& subject) {
  const bool number = std::all_of(subject.object.begin(), subject.object.end(),
                                  [](char c) { return c >= '0' && c <= '9'; });
  return (number ? "object " + subject.object : Shortened(subject.object)) + ", pos. " +
         std::to_string(subject.position);
}

std::string Legend(bool beside_thesis) {
  return "<p class=\"legend\">" + HeatLegend(HeatHue::kRight, "right: 0", "100 %") +
         HeatLegend(HeatHue::kWrong, "wrong: 0", "100 % of the row's views") +
         (beside_thesis ? "<span class=\"small\">(in brackets: the thesis)</span>" : "") + "</p>";
}

}  // namespace

std::string ClassFigure(std::span<const ConfusionRow> rows, bool beside_thesis) {
  HeatGrid grid(
      kLabels.size(), kLabels.size(),
      {.cell_width_px = 76, .cell_height_px = 46, .left_px = 136, .top_px = 62, .right_px = 180});
  grid.Text({136 + 3.5 * 76, 16}, "middle", "answer");
  grid.Text({136 - 8, 51}, "end", "truth");
  grid.Text({136 + 7 * 76 + 10, 51}, "start", "right (95 % interval)");
  NameColumns(&grid);
  for (size_t r = 0; r < kLabels.size(); ++r) {
    const std::vector<ConfusionRow> own = RowsOf(kLabels[r], rows);
    Counts counts{};
    for (const ConfusionRow& row : own) {
      for (size_t k = 0; k < counts.size(); ++k) counts[k] += row.counts[k];
    }
    const evaluation::SuccessRate rate = evaluation::OverallRate(own);
    grid.RowName(r, PlainName(kLabels[r]));
    if (rate.n == 0) {
      grid.RowNote(r, "not tried");
      continue;
    }
    const CellStyle style{.decimals = 1,
                          .css = "cell large",
                          .anchor = "middle",
                          .number_px = {0, 0},
                          .thesis_anchor = "middle",
                          .thesis_px = {0, 15},
                          .thesis_css = "cell thesis below"};
    DrawAnswers(r, PlainName(kLabels[r]), kLabels[r], counts, rate.n,
                beside_thesis ? ThesisOf(own) : std::nullopt, style, &grid);
    const evaluation::Interval interval = evaluation::WilsonInterval(rate);
    grid.RowNote(r, std::to_string(rate.right) + " of " + std::to_string(rate.n) + " (" +
                        Fixed(100.0 * interval.low_1, 1) + "–" + Fixed(100.0 * interval.high_1, 1) +
                        " %)");
  }
  return "<figure class=\"card\">" + grid.Svg("confusion matrix: truth by answer, in percent") +
         Legend(beside_thesis) + "</figure>";
}

std::string RowFigures(std::span<const ConfusionRow> rows, bool beside_thesis) {
  std::string html = "<div class=\"blocks\">";
  for (const GeonLabel truth : kLabels) {
    const std::vector<ConfusionRow> own = RowsOf(truth, rows);
    if (own.empty()) continue;
    HeatGrid grid(own.size(), kLabels.size(),
                  {.cell_width_px = 54, .cell_height_px = 22, .left_px = 130, .top_px = 34});
    NameColumns(&grid);
    for (size_t r = 0; r < own.size(); ++r) {
      const std::string name = RowTitle(own[r].subject);
      grid.RowName(r, name);
      const std::vector<ConfusionRow> one = {own[r]};
      DrawAnswers(r, PlainName(truth) + ", " + name, truth, own[r].counts, own[r].n(),
                  beside_thesis ? ThesisOf(one) : std::nullopt, {}, &grid);
    }
    html += "<figure class=\"card\"><h3>" + PlainName(truth) + "</h3>" +
            grid.Svg(PlainName(truth) + ": objects and positions by answer, in percent") +
            "</figure>";
  }
  return html + "</div>" + Legend(beside_thesis);
}

}  // namespace geon::cli
