#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace geon::cli {

// Pieces of HTML and SVG as text. Classes are styled by the page (report_page.cc).

// Text that may hold < > & and quotes.
std::string Escape(std::string_view text);
// A number with so many decimals.
std::string Fixed(double value, int decimals);
// The bytes of a file as a data URI: "data:image/png;base64,...".
std::string DataUri(const std::string& mime_type, const std::vector<uint8_t>& bytes);

// A figure and what it counts, for a row of class `facts`: pieces of HTML both.
std::string Fact(const std::string& value, const std::string& name);

// A drawing area that maps world coordinates (y up) to pixels (y down).
class Plot {
 public:
  // Fits `low` .. `high` into the area; with `equal_scale` both axes get the smaller scale.
  Plot(double width_px, double height_px, const Eigen::Vector2d& low, const Eigen::Vector2d& high,
       bool equal_scale);

  Eigen::Vector2d At(const Eigen::Vector2d& p) const;
  double Length(double world) const { return world * scale_.x(); }

  void Line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, std::string_view css);
  void Polyline(const std::vector<Eigen::Vector2d>& points, std::string_view css);
  void Polygon(const std::vector<Eigen::Vector2d>& points, std::string_view css);
  void Dots(const std::vector<Eigen::Vector2d>& points, double radius_px, std::string_view css);
  void Circle(const Eigen::Vector2d& centre, double radius, std::string_view css);  // world radius
  // Two opposite corners; `title` is shown when the mouse rests on it.
  void Rect(const Eigen::Vector2d& a, const Eigen::Vector2d& b, std::string_view css,
            std::string_view title = "");
  void Band(double low_y, double high_y, std::string_view css);
  // `anchor` is start, middle or end; the offset is in pixels.
  void Text(const Eigen::Vector2d& at, const Eigen::Vector2d& offset_px, std::string_view anchor,
            std::string_view css, std::string_view text);

  // The whole <svg>; `label` says to screen readers what it shows.
  std::string Svg(std::string_view label) const;

 private:
  std::string Points(const std::vector<Eigen::Vector2d>& points) const;

  double width_px_;
  double height_px_;
  Eigen::Vector2d low_;
  Eigen::Vector2d scale_;
  Eigen::Vector2d offset_px_;
  std::string body_;
};

}  // namespace geon::cli
