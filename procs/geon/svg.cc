#include "procs/geon/svg.h"

#include <algorithm>
#include <cstdio>

namespace geon::cli {
namespace {

std::string Attribute(std::string_view name, const std::string& value) {
  return " " + std::string(name) + "=\"" + value + "\"";
}

std::string Css(std::string_view css) { return Attribute("class", std::string(css)); }

std::string Px(double value) { return Fixed(value, 1); }

}  // namespace

std::string Escape(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '&':
        escaped += "&amp;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string Fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string DataUri(const std::string& mime_type, const std::vector<uint8_t>& bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string uri = "data:" + mime_type + ";base64,";
  uri.reserve(uri.size() + bytes.size() * 4 / 3 + 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t three = uint32_t{bytes[i]} << 16U;
    if (i + 1 < bytes.size()) three |= uint32_t{bytes[i + 1]} << 8U;
    if (i + 2 < bytes.size()) three |= bytes[i + 2];
    uri += kDigits[three >> 18U];
    uri += kDigits[(three >> 12U) & 63U];
    uri += i + 1 < bytes.size() ? kDigits[(three >> 6U) & 63U] : '=';
    uri += i + 2 < bytes.size() ? kDigits[three & 63U] : '=';
  }
  return uri;
}

std::string Fact(const std::string& value, const std::string& name) {
  return "<div><b>" + value + "</b><span>" + name + "</span></div>";
}

Plot::Plot(double width_px, double height_px, const Eigen::Vector2d& low,
           const Eigen::Vector2d& high, bool equal_scale)
    : width_px_(width_px), height_px_(height_px), low_(low) {
  const Eigen::Vector2d size = (high - low).cwiseMax(1e-9);
  scale_ = Eigen::Vector2d(width_px, height_px).cwiseQuotient(size);
  if (equal_scale) scale_.setConstant(scale_.minCoeff());
  offset_px_ = 0.5 * (Eigen::Vector2d(width_px, height_px) - size.cwiseProduct(scale_));
}

Eigen::Vector2d Plot::At(const Eigen::Vector2d& p) const {
  const Eigen::Vector2d px = offset_px_ + (p - low_).cwiseProduct(scale_);
  return {px.x(), height_px_ - px.y()};
}

std::string Plot::Points(const std::vector<Eigen::Vector2d>& points) const {
  std::string text;
  for (const Eigen::Vector2d& p : points) {
    const Eigen::Vector2d px = At(p);
    text += Px(px.x()) + "," + Px(px.y()) + " ";
  }
  return Attribute("points", text);
}

void Plot::Line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, std::string_view css) {
  Polyline({a, b}, css);
}

void Plot::Polyline(const std::vector<Eigen::Vector2d>& points, std::string_view css) {
  if (points.size() >= 2) body_ += "<polyline" + Css(css) + Points(points) + "/>";
}

void Plot::Polygon(const std::vector<Eigen::Vector2d>& points, std::string_view css) {
  if (points.size() >= 3) body_ += "<polygon" + Css(css) + Points(points) + "/>";
}

void Plot::Dots(const std::vector<Eigen::Vector2d>& points, double radius_px,
                std::string_view css) {
  if (points.empty()) return;
  body_ += "<g" + Css(css) + ">";
  for (const Eigen::Vector2d& p : points) {
    const Eigen::Vector2d px = At(p);
    body_ += "<circle" + Attribute("cx", Px(px.x())) + Attribute("cy", Px(px.y())) +
             Attribute("r", Px(radius_px)) + "/>";
  }
  body_ += "</g>";
}

void Plot::Circle(const Eigen::Vector2d& centre, double radius, std::string_view css) {
  Dots({centre}, Length(radius), css);
}

void Plot::Rect(const Eigen::Vector2d& a, const Eigen::Vector2d& b, std::string_view css,
                std::string_view title) {
  const Eigen::Vector2d low_px = At(a).cwiseMin(At(b));
  const Eigen::Vector2d size_px = (At(a) - At(b)).cwiseAbs();
  body_ += "<rect" + Css(css) + Attribute("x", Px(low_px.x())) + Attribute("y", Px(low_px.y())) +
           Attribute("width", Px(size_px.x())) + Attribute("height", Px(size_px.y()));
  body_ += title.empty() ? "/>" : "><title>" + Escape(title) + "</title></rect>";
}

void Plot::Band(double low_y, double high_y, std::string_view css) {
  const double top_px = At({low_.x(), high_y}).y();
  const double bottom_px = At({low_.x(), low_y}).y();
  body_ += "<rect" + Css(css) + Attribute("x", "0") + Attribute("y", Px(top_px)) +
           Attribute("width", Px(width_px_)) +
           Attribute("height", Px(std::max(bottom_px - top_px, 0.0))) + "/>";
}

void Plot::Text(const Eigen::Vector2d& at, const Eigen::Vector2d& offset_px,
                std::string_view anchor, std::string_view css, std::string_view text) {
  const Eigen::Vector2d px = At(at) + offset_px;
  body_ += "<text" + Css(css) + Attribute("x", Px(px.x())) + Attribute("y", Px(px.y())) +
           Attribute("text-anchor", std::string(anchor)) + ">" + Escape(text) + "</text>";
}

std::string Plot::Svg(std::string_view label) const {
  return "<svg" + Attribute("viewBox", "0 0 " + Px(width_px_) + " " + Px(height_px_)) +
         " role=\"img\"" + Attribute("aria-label", Escape(label)) + ">" + body_ + "</svg>";
}

}  // namespace geon::cli
