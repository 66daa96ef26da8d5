#include "procs/geon/report_figures.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "procs/geon/svg.h"
#include "procs/geon/verdict_text.h"

namespace geon::cli {
namespace {

constexpr double kRobotRadius_m = 0.267;

// The mask's outlines as an SVG path in the mask's pixels.
std::string OutlinePath(const sensor::Image& mask) {
  if (mask.data.empty()) return "";
  cv::Mat pixels;
  try {
    pixels = cv::imdecode(mask.data, cv::IMREAD_GRAYSCALE);
  } catch (const cv::Exception&) {
    return "";  // a damaged mask: the picture is shown without it
  }
  if (pixels.empty()) return "";
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(pixels, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_TC89_L1);
  std::string path;
  for (const auto& outline : outlines) {
    for (size_t i = 0; i < outline.size(); ++i) {
      path +=
          (i == 0 ? "M" : "L") + std::to_string(outline[i].x) + " " + std::to_string(outline[i].y);
    }
    path += "Z";
  }
  return path;
}

struct Bounds {
  Eigen::Vector2d low{1e9, 1e9};
  Eigen::Vector2d high{-1e9, -1e9};
  void Add(const Eigen::Vector2d& p, double margin_m) {
    low = low.cwiseMin(p.array().matrix() - Eigen::Vector2d::Constant(margin_m));
    high = high.cwiseMax(p.array().matrix() + Eigen::Vector2d::Constant(margin_m));
  }
};

Bounds MapBounds(const RunRecord& run, const std::vector<Eigen::Vector2d>& path,
                 const std::optional<Truth>& truth) {
  Bounds bounds;
  for (const Eigen::Vector2d& p : path) bounds.Add(p, kRobotRadius_m + 0.15);
  for (const sensor::PlannerState& state : run.safe_states) {
    for (const Eigen::Vector2d& p : state.safe_polygon_W_m) bounds.Add(p, 0.1);
  }
  if (run.last_state && run.last_state->p_WTarget_m) bounds.Add(*run.last_state->p_WTarget_m, 0.3);
  if (truth) {
    for (const Truth::Object& object : truth->objects) bounds.Add({object.x_m, object.y_m}, 0.2);
  }
  return bounds;
}

void DrawRobot(const sensor::BaseState& at, const char* css, Plot* plot) {
  const Eigen::Vector2d p(at.x_m, at.y_m);
  plot->Circle(p, kRobotRadius_m, css);
  plot->Line(
      p, p + kRobotRadius_m * Eigen::Vector2d(std::cos(at.heading_rad), std::sin(at.heading_rad)),
      "heading");
}

std::string MapLegend(bool truth) {
  std::string legend =
      "<p class=\"legend\"><span class=\"key path-key\"></span>path by odometry "
      "<span class=\"key safe-key\"></span>safe polygons "
      "<span class=\"key obstacle-key\"></span>obstacles seen "
      "<span class=\"key target-key\"></span>target as supposed";
  if (truth) legend += " <span class=\"key truth-key\"></span>what really stood there";
  return legend + "</p>";
}

}  // namespace

std::string ViewFigure(const sensor::TargetView& view) {
  const std::string width = std::to_string(view.view.width_px);
  const std::string height = std::to_string(view.view.height_px);
  std::string html = "<svg class=\"view\" viewBox=\"0 0 " + width + " " + height +
                     "\" role=\"img\" aria-label=\"camera picture with target\"><image width=\"" +
                     width + "\" height=\"" + height + "\" href=\"" +
                     DataUri("image/jpeg", view.view.data) + "\"/>";
  const std::string path = OutlinePath(view.mask);
  if (!path.empty()) {
    const double scale =
        view.mask.width_px > 0 ? static_cast<double>(view.view.width_px) / view.mask.width_px : 1.0;
    html +=
        "<path class=\"mask\" transform=\"scale(" + Fixed(scale, 4) + ")\" d=\"" + path + "\"/>";
  }
  if (view.target_box) {
    const sensor::PixelBox& box = *view.target_box;
    html += "<rect class=\"box\" x=\"" + std::to_string(box.u_px) + "\" y=\"" +
            std::to_string(box.v_px) + "\" width=\"" + std::to_string(box.w_px) + "\" height=\"" +
            std::to_string(box.h_px) + "\"/>";
  }
  return html + "</svg>";
}

std::string PosteriorFigure(const sensor::GeonVerdict& verdict) {
  std::string html = "<div class=\"posterior\">";
  for (size_t i = 0; i < verdict.posterior.size(); ++i) {
    const double percent = 100.0 * verdict.posterior[i];
    const auto label = static_cast<GeonLabel>(i);
    html += std::string("<div class=\"row") + (label == verdict.label ? " chosen" : "") +
            "\"><span>" + PlainName(label) +
            "</span><span class=\"track\"><i style=\"width:" + Fixed(percent, 1) +
            "%\"></i></span><span class=\"number\">" + Fixed(percent, 0) + " %</span></div>";
  }
  return html + "</div>";
}

std::string MapFigure(const RunRecord& run, const std::optional<Truth>& truth) {
  if (run.path.empty()) return "<p class=\"muted\">No odometry in the log.</p>";
  std::vector<Eigen::Vector2d> path;
  for (const sensor::BaseState& state : run.path) path.emplace_back(state.x_m, state.y_m);
  const Bounds bounds = MapBounds(run, path, truth);
  const Eigen::Vector2d size = bounds.high - bounds.low;
  constexpr double kMapWidth_px = 680.0;
  const double height_px = std::clamp(kMapWidth_px * size.y() / size.x(), 260.0, 640.0);
  Plot plot(kMapWidth_px, height_px, bounds.low, bounds.high, true);
  std::vector<Eigen::Vector2d> obstacles;
  for (size_t i = 0; i < run.safe_states.size(); ++i) {
    const bool last = i + 1 == run.safe_states.size();
    plot.Polygon(run.safe_states[i].safe_polygon_W_m, last ? "safe last" : "safe");
    const auto& seen = run.safe_states[i].obstacles_W_m;
    obstacles.insert(obstacles.end(), seen.begin(), seen.end());
  }
  plot.Dots(obstacles, 1.8, "obstacle");
  if (truth) {
    for (const Truth::Object& object : truth->objects) {
      const Eigen::Vector2d p(object.x_m, object.y_m);
      plot.Circle(p, 0.06, "truth");
      plot.Text(p, {8, -6}, "start", "small",
                object.label ? PlainName(*object.label) : object.kind);
    }
  }
  plot.Polyline(path, "path");
  DrawRobot(run.path.front(), "robot start", &plot);
  DrawRobot(run.path.back(), "robot", &plot);
  plot.Text(path.front(), {0, 4}, "middle", "small", "start");
  if (run.last_state && run.last_state->p_WTarget_m) {
    const Eigen::Vector2d p = *run.last_state->p_WTarget_m;
    constexpr double r_m = 0.07;
    plot.Polygon({p + Eigen::Vector2d(r_m, 0), p + Eigen::Vector2d(0, r_m),
                  p - Eigen::Vector2d(r_m, 0), p - Eigen::Vector2d(0, r_m)},
                 "goal");
  }
  const Eigen::Vector2d bar = bounds.low + 0.03 * size;
  plot.Line(bar, bar + Eigen::Vector2d(0.5, 0), "scale");
  plot.Text(bar + Eigen::Vector2d(0.5, 0), {5, 4}, "start", "small", "0.5 m");
  return plot.Svg("map of the run from above") + MapLegend(truth.has_value());
}

std::string TimelineFigure(const RunRecord& run) {
  if (run.phases.empty()) return "<p class=\"muted\">The planner did not speak.</p>";
  const double total_s = std::max(run.duration_s, 1e-3);
  std::string bar = "<div class=\"bar\">";
  std::string list = "<table class=\"phases\"><tbody>";
  double at_s = 0.0;
  for (const PhaseSpan& span : run.phases) {
    const auto width = [total_s](double from_s, double to_s) {
      return "style=\"width:" + Fixed(100.0 * (to_s - from_s) / total_s, 3) + "%\"";
    };
    if (span.begin_s > at_s) bar += "<i class=\"silent\" " + width(at_s, span.begin_s) + "></i>";
    const std::string phase = Escape(span.phase);
    bar += "<i class=\"phase " + phase + "\" " + width(span.begin_s, span.end_s) + " title=\"" +
           phase + "\"></i>";
    list += "<tr><td class=\"number\">" + Fixed(span.begin_s, 1) +
            " s</td><td><span class=\"dot phase " + phase + "\"></span>" + phase +
            "</td><td class=\"number\">" + Fixed(span.end_s - span.begin_s, 1) + " s</td><td>" +
            Escape(span.text) + "</td></tr>";
    at_s = span.end_s;
  }
  return bar + "</div>" + list + "</tbody></table>";
}

}  // namespace geon::cli
