#pragma once

#include <Eigen/Core>
#include <string>

#include "procs/geon/svg.h"

namespace geon::cli {

// Blue for what is right, orange for what is wrong: told apart by the colour-blind, and each from
// light to dark in eight steps (classes b0..b8 and o0..o8 of experiment_style.h).
enum class HeatHue { kRight, kWrong };

// The class of a share: step 0 (white) is exactly nothing, steps 1 to 8 are equal parts of 0 to 1,
// so that one case in a thousand can be seen.
std::string HeatClass(HeatHue hue, double share_1);

// The eight steps side by side, with what they run from and to.
std::string HeatLegend(HeatHue hue, const std::string& from, const std::string& to);

// A grid of coloured cells with names along its sides: a drawing in pixels, rows from the top.
class HeatGrid {
 public:
  struct Layout {
    double cell_width_px = 20.0, cell_height_px = 20.0;
    double left_px = 60.0, top_px = 30.0, right_px = 0.0, bottom_px = 0.0;
  };
  HeatGrid(size_t rows, size_t columns, const Layout& layout);

  void Cell(size_t row, size_t column, HeatHue hue, double share_1, const std::string& title);
  // Text on a cell, at (right, down) from its middle; light where `share_1` is dark.
  void CellText(size_t row, size_t column, const Eigen::Vector2d& offset_px,
                const std::string& anchor, const std::string& css, double share_1,
                const std::string& text);
  void RowName(size_t row, const std::string& name);
  void RowNote(size_t row, const std::string& note);        // on the right
  void ColumnName(size_t column, const std::string& name);  // one line or two: breaks at a space
  // Text anywhere, in pixels from the upper left corner.
  void Text(const Eigen::Vector2d& at_px, const std::string& anchor, const std::string& text);
  void Frame(size_t row, size_t column);  // points a cell out

  std::string Svg(const std::string& label) const { return plot_.Svg(label); }

 private:
  Eigen::Vector2d Up(const Eigen::Vector2d& down_px) const;
  Eigen::Vector2d Corner(size_t row, size_t column) const;  // upper left, y down

  Layout layout_;
  double columns_px_;
  double height_px_;
  Plot plot_;
};

}  // namespace geon::cli
