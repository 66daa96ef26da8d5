#include "procs/geon/heat_grid.h"

#include <algorithm>
#include <cmath>

namespace geon::cli {
namespace {

constexpr int kSteps = 8;
constexpr int kFirstDarkStep = 6;  // from here on text is white

int Step(double share_1) {
  if (!(share_1 > 0.0)) return 0;
  return std::clamp(static_cast<int>(std::ceil(share_1 * kSteps - 1e-9)), 1, kSteps);
}

}  // namespace

std::string HeatClass(HeatHue hue, double share_1) {
  return (hue == HeatHue::kRight ? "b" : "o") + std::to_string(Step(share_1));
}

std::string HeatLegend(HeatHue hue, const std::string& from, const std::string& to) {
  std::string html = "<span class=\"ramp\">" + Escape(from);
  for (int step = 1; step <= kSteps; ++step) {
    html += "<i class=\"" + HeatClass(hue, static_cast<double>(step) / kSteps) + "\"></i>";
  }
  return html + Escape(to) + "</span>";
}

HeatGrid::HeatGrid(size_t rows, size_t columns, const Layout& layout)
    : layout_(layout),
      columns_px_(static_cast<double>(columns) * layout.cell_width_px),
      height_px_(layout.top_px + static_cast<double>(rows) * layout.cell_height_px +
                 layout.bottom_px),
      plot_(layout.left_px + columns_px_ + layout.right_px, height_px_, {0, 0},
            {layout.left_px + columns_px_ + layout.right_px, height_px_}, false) {}

Eigen::Vector2d HeatGrid::Up(const Eigen::Vector2d& down_px) const {
  return {down_px.x(), height_px_ - down_px.y()};
}

Eigen::Vector2d HeatGrid::Corner(size_t row, size_t column) const {
  return {layout_.left_px + static_cast<double>(column) * layout_.cell_width_px,
          layout_.top_px + static_cast<double>(row) * layout_.cell_height_px};
}

void HeatGrid::Cell(size_t row, size_t column, HeatHue hue, double share_1,
                    const std::string& title) {
  plot_.Rect(Up(Corner(row, column)), Up(Corner(row + 1, column + 1)),
             "heat " + HeatClass(hue, share_1), title);
}

void HeatGrid::CellText(size_t row, size_t column, const Eigen::Vector2d& offset_px,
                        const std::string& anchor, const std::string& css, double share_1,
                        const std::string& text) {
  const Eigen::Vector2d middle = 0.5 * (Corner(row, column) + Corner(row + 1, column + 1));
  plot_.Text(Up(middle), offset_px, anchor, css + (Step(share_1) >= kFirstDarkStep ? " on" : ""),
             text);
}

void HeatGrid::RowName(size_t row, const std::string& name) {
  const Eigen::Vector2d at = Corner(row, 0) + Eigen::Vector2d(-8, 0.5 * layout_.cell_height_px + 4);
  Text(at, "end", name);
}

void HeatGrid::RowNote(size_t row, const std::string& note) {
  const double x_px = layout_.left_px + columns_px_ + 10;
  Text({x_px, Corner(row, 0).y() + 0.5 * layout_.cell_height_px + 4}, "start", note);
}

void HeatGrid::ColumnName(size_t column, const std::string& name) {
  constexpr double kLine_px = 12.0;
  const size_t space = name.find(' ');
  Eigen::Vector2d at = Corner(0, column) + Eigen::Vector2d(0.5 * layout_.cell_width_px, -7);
  if (space == std::string::npos) return Text(at, "middle", name);
  Text(at - Eigen::Vector2d(0, kLine_px), "middle", name.substr(0, space));
  Text(at, "middle", name.substr(space + 1));
}

void HeatGrid::Text(const Eigen::Vector2d& at_px, const std::string& anchor,
                    const std::string& text) {
  plot_.Text(Up(at_px), {0, 0}, anchor, "name", text);
}

void HeatGrid::Frame(size_t row, size_t column) {
  plot_.Rect(Up(Corner(row, column)), Up(Corner(row + 1, column + 1)), "worst-cell");
}

}  // namespace geon::cli
