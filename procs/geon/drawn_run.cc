#include "procs/geon/drawn_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angles.h"
#include "procs/geon/svg.h"

namespace geon::cli {
namespace {

using nlohmann::json;
using GroundPoints = std::vector<Eigen::Vector2d>;

json PointsJson(const GroundPoints& points_m) {
  json value = json::array();
  for (const Eigen::Vector2d& p_m : points_m) value.push_back(PointJson(p_m));
  return value;
}
GroundPoints ParsePoints(const json& value) {
  GroundPoints points_m;
  for (const json& each : value) points_m.push_back(ParsePoint(each));
  return points_m;
}

GroundPoints CircleOutline(const Eigen::Vector2d& centre_m, double radius_m) {
  constexpr int kCorners = 16;
  GroundPoints outline_m;
  for (int k = 0; k < kCorners; ++k) {
    const double angle_rad = 2.0 * kPi * k / kCorners;
    outline_m.push_back(centre_m +
                        radius_m * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad)));
  }
  return outline_m;
}

// Stops at the same place, more or less, share a label: "1, 2, 5".
struct Stop {
  Eigen::Vector2d place_m;
  std::string label;
};
std::vector<Stop> Stops(const GroundPoints& stops_m) {
  constexpr double kApart_m = 0.15;
  std::vector<Stop> stops;
  for (size_t k = 0; k < stops_m.size(); ++k) {
    const std::string number = std::to_string(k + 1);
    const auto same = std::find_if(stops.begin(), stops.end(), [&](const Stop& each) {
      return (each.place_m - stops_m[k]).norm() < kApart_m;
    });
    if (same == stops.end()) {
      stops.push_back({stops_m[k], number});
    } else {
      same->label += ", " + number;
    }
  }
  return stops;
}

}  // namespace

const char* const kDrawnRunStyle = R"css(
.maps{display:grid;grid-template-columns:repeat(auto-fill,minmax(250px,1fr));gap:16px}
.maps figure{margin:0}.maps figcaption{font-size:13px;line-height:1.35}
.pen{fill:#f7f8f8;stroke:#5d666d;stroke-width:2}.thing{fill:#b9c3cc;stroke:#5d666d;stroke-width:1}
.way{fill:none;stroke:var(--accent);stroke-width:1.6}.start{fill:none;stroke:var(--accent);stroke-width:1.2}
.stand{fill:none;stroke:var(--second);stroke-width:2}.geon{fill:#96281b}
.stop{fill:var(--ink)}svg text.stop-number{fill:var(--ink);font-weight:600;paint-order:stroke;stroke:#fff;stroke-width:3px}
table.runs{border-collapse:collapse}table.runs th,table.runs td{padding:3px 10px;text-align:right}
table.runs th:first-child,table.runs td:first-child{text-align:left}
)css";

DrawnRun DrawRun(int t, const sim::World& world, const GroundPoints& path_m) {
  DrawnRun run;
  run.t = t;
  run.pen_m = world.pen_size_m;
  for (const sim::WorldObject& object : world.objects) {
    const Eigen::Vector2d place_m(object.x_m, object.y_m);
    if (std::holds_alternative<sim::BoxShape>(object.shape)) {
      run.outlines_m.push_back(sim::BoxOutline(object));
    } else if (const auto* cylinder = std::get_if<sim::CylinderShape>(&object.shape)) {
      run.outlines_m.push_back(CircleOutline(place_m, cylinder->radius_m));
    } else if (sim::IsTarget(object)) {
      run.geons_m.push_back(place_m);
    }
  }
  run.path_m = path_m;
  return run;
}

void AddDrawnRun(DrawnRun run, std::vector<DrawnRun>* runs) {
  const auto after = std::upper_bound(runs->begin(), runs->end(), run.t,
                                      [](int t, const DrawnRun& each) { return t < each.t; });
  runs->insert(after, std::move(run));
  if (runs->size() > kMostDrawnRuns) runs->pop_back();
}

json PointJson(const Eigen::Vector2d& p_m) { return {p_m.x(), p_m.y()}; }
Eigen::Vector2d ParsePoint(const json& value) {
  return {value.at(0).get<double>(), value.at(1).get<double>()};
}

json ToJson(const DrawnRun& run) {
  json outlines = json::array();
  for (const GroundPoints& outline_m : run.outlines_m) outlines.push_back(PointsJson(outline_m));
  json value = {{"t", run.t},
                {"pen_m", PointJson(run.pen_m)},
                {"outlines_m", outlines},
                {"geons_m", PointsJson(run.geons_m)},
                {"path_m", PointsJson(run.path_m)}};
  if (!run.picture_uri.empty()) value["picture"] = run.picture_uri;
  return value;
}

DrawnRun ParseDrawnRun(const json& value) {
  DrawnRun run;
  run.t = value.at("t");
  run.pen_m = ParsePoint(value.at("pen_m"));
  for (const json& outline : value.at("outlines_m")) run.outlines_m.push_back(ParsePoints(outline));
  run.geons_m = ParsePoints(value.at("geons_m"));
  run.path_m = ParsePoints(value.at("path_m"));
  run.picture_uri = value.value("picture", "");
  return run;
}

std::string RunMap(const DrawnRun& run, const GroundPoints& stops_m) {
  constexpr double kWidth_px = 260.0;
  const double height_px = kWidth_px * run.pen_m.y() / run.pen_m.x() + 8.0;
  const Eigen::Vector2d edge_m(0.05, 0.05);
  Plot plot(kWidth_px, height_px, -edge_m, run.pen_m + edge_m, true);
  plot.Polygon({{0.0, 0.0}, {run.pen_m.x(), 0.0}, run.pen_m, {0.0, run.pen_m.y()}}, "pen");
  for (const GroundPoints& outline_m : run.outlines_m) plot.Polygon(outline_m, "thing");
  plot.Polyline(run.path_m, "way");
  if (!run.path_m.empty()) {
    plot.Circle(run.path_m.front(), sim::kRobotRadius_m, "start");
    plot.Circle(run.path_m.back(), sim::kRobotRadius_m, "stand");
  }
  for (const Eigen::Vector2d& geon_m : run.geons_m) plot.Circle(geon_m, 0.08, "geon");
  for (const Stop& stop : Stops(stops_m)) {
    plot.Dots({stop.place_m}, 2.5, "stop");
    plot.Text(stop.place_m, {5, -5}, "start", "stop-number", stop.label);
  }
  return plot.Svg("Map of run " + std::to_string(run.t));
}

}  // namespace geon::cli
