#include "procs/geon/experiment_figures.h"

#include <algorithm>
#include <set>

#include "procs/geon/experiment_rates.h"
#include "procs/geon/heat_grid.h"
#include "procs/geon/svg.h"

namespace geon::cli {
namespace {

using evaluation::CellRate;
using evaluation::Reliability;
using evaluation::ReliabilityBin;
using evaluation::SuccessRate;

constexpr double kPlotWidth_px = 600.0;
// Room for the axes, in the unit of the confidence axis.
constexpr double kLeft_1 = -0.12;
constexpr double kRight_1 = 1.03;

SuccessRate WrongOf(const SuccessRate& rate) { return {rate.n - rate.right, rate.n}; }

// The end of the colour scale: the next round number above the largest error, at least a tenth, so
// that a single error does not look like a disaster.
double ScaleEnd(std::span<const CellRate> cells) {
  double largest_1 = 0.0;
  for (const CellRate& cell : cells) largest_1 = std::max(largest_1, WrongOf(cell.rate).value_1());
  for (const double end_1 : {0.1, 0.2, 0.3, 0.4, 0.5}) {
    if (largest_1 <= end_1) return end_1;
  }
  return 1.0;
}

size_t PlaceOf(int value, const std::set<int>& values) {
  return static_cast<size_t>(std::distance(values.begin(), values.find(value)));
}

void DrawCell(const CellRate& cell, size_t row, size_t column, double end_1, HeatGrid* grid) {
  const SuccessRate wrong = WrongOf(cell.rate);
  const double share_1 = wrong.value_1() / end_1;
  grid->Cell(row, column, HeatHue::kWrong, share_1,
             "elevation " + std::to_string(WholeDegrees(cell.cell.elevation_rad)) + "°, azimuth " +
                 std::to_string(WholeDegrees(cell.cell.azimuth_rad)) +
                 "°: " + std::to_string(wrong.right) + " of " + std::to_string(wrong.n) +
                 " wrong, " + PercentWithInterval(wrong));
  if (wrong.right == 0) return;
  grid->CellText(row, column, {0, 4}, "middle", "cell tiny", share_1,
                 Fixed(100.0 * wrong.value_1(), 0));
}

void DrawFrame(const std::vector<double>& ticks_1, double height, Plot* plot) {
  for (const double at_1 : ticks_1) {
    plot->Line({at_1, 0.0}, {at_1, height}, "grid");
    plot->Text({at_1, 0.0}, {0, 15}, "middle", "name", Fixed(at_1, 1));
  }
}

std::string AccuracySvg(const Reliability& reliability) {
  Plot plot(kPlotWidth_px, 360, {kLeft_1, -0.14}, {kRight_1, 1.04}, false);
  const std::vector<double> ticks_1 = {0.0, 0.2, 0.4, 0.6, 0.8, 1.0};
  DrawFrame(ticks_1, 1.0, &plot);
  for (const double at_1 : ticks_1) {
    plot.Line({0.0, at_1}, {1.0, at_1}, "grid");
    plot.Text({0.0, at_1}, {-6, 4}, "end", "name", Fixed(100.0 * at_1, 0) + " %");
  }
  for (const ReliabilityBin& bin : reliability.bins) {
    if (bin.rate.n == 0) continue;
    plot.Rect({bin.low_1 + 0.004, 0.0}, {bin.high_1 - 0.004, bin.rate.value_1()}, "bin",
              "confidence " + Fixed(bin.low_1, 2) + " to " + Fixed(bin.high_1, 2) + ", mean " +
                  Fixed(bin.mean_confidence_1, 3) + ": " + std::to_string(bin.rate.right) + " of " +
                  std::to_string(bin.rate.n) + " right, " + PercentWithInterval(bin.rate));
    const evaluation::Interval interval = evaluation::WilsonInterval(bin.rate);
    plot.Line({bin.mean_confidence_1, interval.low_1}, {bin.mean_confidence_1, interval.high_1},
              "whisker");
    plot.Dots({{bin.mean_confidence_1, bin.rate.value_1()}}, 3.0, "mean");
  }
  plot.Line({0.0, 0.0}, {1.0, 1.0}, "diagonal");
  plot.Rect({0.0, 0.0}, {1.0, 1.0}, "frame");
  plot.Text({0.5, -0.14}, {0, -6}, "middle", "axis-name", "confidence the recogniser gave");
  plot.Text({0.0, 1.0}, {8, 16}, "start", "axis-name", "answers that were right");
  return plot.Svg("reliability diagram: right answers by confidence");
}

std::string CountsSvg(const Reliability& reliability) {
  int most = 1;
  for (const ReliabilityBin& bin : reliability.bins) most = std::max(most, bin.rate.n);
  // The upper quarter is for the numbers on the bars, the lower third for the axis.
  Plot plot(kPlotWidth_px, 130, {kLeft_1, -0.48 * most}, {kRight_1, 1.28 * most}, false);
  DrawFrame({0.0, 0.2, 0.4, 0.6, 0.8, 1.0}, 1.25 * most, &plot);
  for (const ReliabilityBin& bin : reliability.bins) {
    plot.Rect({bin.low_1 + 0.004, 0.0}, {bin.high_1 - 0.004, bin.rate.n}, "bin");
    plot.Text({0.5 * (bin.low_1 + bin.high_1), bin.rate.n}, {0, -4}, "middle", "cell tiny",
              std::to_string(bin.rate.n));
  }
  plot.Line({0.0, 0.0}, {1.0, 0.0}, "whisker");
  plot.Text({0.5, -0.48 * most}, {0, -4}, "middle", "axis-name",
            "confidence; numbers: answers given with it");
  return plot.Svg("number of answers by confidence");
}

std::string DecidedRow(const std::string& name, const SuccessRate& rate, int of) {
  const SuccessRate share{rate.n, of};
  std::string html = "<tr><td>" + name + "</td><td class=\"number\">" + std::to_string(rate.n) +
                     "</td><td class=\"number\">" + Fixed(100.0 * share.value_1(), 1) +
                     " %</td><td class=\"number\">" + std::to_string(rate.n - rate.right) +
                     "</td><td class=\"number\">";
  if (rate.n == 0) return html + "–</td><td class=\"number\">–</td></tr>";
  const evaluation::Interval interval = evaluation::WilsonInterval(rate);
  return html + Fixed(100.0 * rate.value_1(), 1) + " %</td><td class=\"number\">" +
         Fixed(100.0 * interval.low_1, 1) + "–" + Fixed(100.0 * interval.high_1, 1) + "</td></tr>";
}

}  // namespace

std::string PercentWithInterval(const SuccessRate& rate) {
  const evaluation::Interval interval = evaluation::WilsonInterval(rate);
  return Fixed(100.0 * rate.value_1(), 1) + " % (95 %: " + Fixed(100.0 * interval.low_1, 1) + "–" +
         Fixed(100.0 * interval.high_1, 1) + ")";
}

std::string SphereFigure(std::span<const CellRate> cells) {
  std::set<int> elevations_deg, azimuths_deg;
  for (const CellRate& cell : cells) {
    elevations_deg.insert(WholeDegrees(cell.cell.elevation_rad));
    azimuths_deg.insert(WholeDegrees(cell.cell.azimuth_rad));
  }
  const size_t rows = elevations_deg.size(), columns = azimuths_deg.size();
  const double width_px = 800.0 / static_cast<double>(columns);
  HeatGrid grid(rows, columns,
                {.cell_width_px = width_px,
                 .cell_height_px = 28,
                 .left_px = 56,
                 .top_px = 30,
                 .right_px = 196,
                 .bottom_px = 40});
  const double end_1 = ScaleEnd(cells);
  const auto row_of = [&](const CellRate& cell) {  // the highest elevation on top
    return rows - 1 - PlaceOf(WholeDegrees(cell.cell.elevation_rad), elevations_deg);
  };
  for (const CellRate& cell : cells) {
    DrawCell(cell, row_of(cell), PlaceOf(WholeDegrees(cell.cell.azimuth_rad), azimuths_deg), end_1,
             &grid);
  }
  for (const CellRate& elevation : evaluation::RatesByElevation(cells)) {
    const int elevation_deg = WholeDegrees(elevation.cell.elevation_rad);
    grid.RowName(row_of(elevation), std::to_string(elevation_deg) + "°");
    grid.RowNote(row_of(elevation), PercentWithInterval(WrongOf(elevation.rate)));
  }
  size_t column = 0;
  const double bottom_px = 30 + 28 * static_cast<double>(rows);
  for (const int azimuth_deg : azimuths_deg) {
    const double x_px = 56 + width_px * (static_cast<double>(column) + 0.5);
    if (column++ % (columns > 12 ? 3 : 1) == 0) {
      grid.Text({x_px, bottom_px + 15}, "middle", std::to_string(azimuth_deg) + "°");
    }
  }
  const double end_px = 56 + width_px * static_cast<double>(columns);
  grid.Text({0.5 * (56 + end_px), bottom_px + 34}, "middle",
            "azimuth of the camera round the object, degrees");
  grid.Text({6, 18}, "start", "elevation, degrees");
  grid.Text({end_px + 10, 18}, "start", "wrong, all azimuths");
  if (const auto worst = evaluation::WorstCell(cells); worst && worst->rate.right < worst->rate.n) {
    grid.Frame(row_of(*worst), PlaceOf(WholeDegrees(worst->cell.azimuth_rad), azimuths_deg));
  }
  return "<figure class=\"card\">" + grid.Svg("error by elevation and azimuth, in percent") +
         "<p class=\"legend\">" +
         HeatLegend(HeatHue::kWrong, "wrong: 0",
                    Fixed(100.0 * end_1, 0) + " % of the cell's views") +
         "<span class=\"small\">numbers: percent wrong, none where nothing is; black frame: the "
         "worst view</span></p></figure>";
}

std::string ReliabilityFigure(const Reliability& reliability) {
  return "<figure class=\"card\">" + AccuracySvg(reliability) + CountsSvg(reliability) +
         "<figcaption>Bars: of the answers given with this confidence, how many were right. Dots "
         "stand at the mean confidence, with the 95 % interval. On the dashed line confidence and "
         "success are the same; below it the recogniser was too sure.</figcaption></figure>";
}

std::string DecidedTable(const Reliability& reliability) {
  return "<table><thead><tr><th></th><th class=\"number\">views</th><th class=\"number\">share</th>"
         "<th class=\"number\">wrong</th><th class=\"number\">right</th>"
         "<th class=\"number\">95 %</th></tr></thead><tbody>" +
         DecidedRow("decided", reliability.decided, reliability.all.n) +
         DecidedRow("undecided", reliability.undecided, reliability.all.n) +
         DecidedRow("all", reliability.all, reliability.all.n) + "</tbody></table>";
}

}  // namespace geon::cli
