#include "procs/geon/calibration_page.h"

#include <algorithm>

#include "base/angles.h"
#include "procs/geon/experiment_style.h"
#include "procs/geon/report_style.h"
#include "procs/geon/svg.h"

namespace geon::cli {
namespace {

using calibration::BoardView;
using geometry::CalibratedRig;

std::string Cell(const std::string& text) { return "<td>" + text + "</td>"; }
std::string NumberCell(const std::string& text) { return "<td class=\"number\">" + text + "</td>"; }

double RangeSigmaAt(const CalibratedRig& record, double distance_m) {
  double worst_m = 0.0;
  for (const geometry::RigRangeSigma& range : record.range_sigmas) {
    if (range.distance_m == distance_m) worst_m = std::max(worst_m, range.sigma_m);
  }
  return worst_m;
}

std::string Facts(const CalibratedRig& record) {
  return "<div class=\"facts\">" + Fact(std::to_string(record.views), "views of the board") +
         Fact(std::to_string(record.stops), "stops of the robot") +
         Fact(Fixed(record.residuals[0].rms_px, 3) + " px", "rms of a corner, B/W") +
         Fact(Fixed(record.residuals[1].rms_px, 3) + " px", "rms of a corner, colour") +
         Fact(Fixed(std::max(record.residuals[2].rms_px, record.residuals[3].rms_px), 3) + " px",
              "rms of a stripe") +
         "</div>";
}

std::string RangeTable(const CalibratedRig& record) {
  std::string html =
      "<table><tr><th>laser</th><th class=\"number\">distance</th><th class=\"number\">range, one "
      "standard deviation</th></tr>";
  for (const geometry::RigRangeSigma& range : record.range_sigmas) {
    html += "<tr>" + Cell(range.laser) + NumberCell(Fixed(range.distance_m, 1) + " m") +
            NumberCell(Fixed(1000.0 * range.sigma_m, 2) + " mm") + "</tr>";
  }
  return html + "</table>";
}

std::string ResidualTable(const CalibratedRig& record) {
  std::string html =
      "<table><tr><th>measurement</th><th class=\"number\">count</th><th "
      "class=\"number\">rms</th><th class=\"number\">outliers</th></tr>";
  for (const geometry::RigResidual& residual : record.residuals) {
    html += "<tr>" + Cell(Escape(residual.what)) + NumberCell(std::to_string(residual.count)) +
            NumberCell(Fixed(residual.rms_px, 3) + " px") +
            NumberCell(std::to_string(residual.outliers)) + "</tr>";
  }
  return html + "</table>";
}

// Where in a camera's picture something was measured.
std::string Coverage(
    const geometry::PinholeCamera& camera, const std::string& caption,
    const std::vector<std::pair<std::vector<Eigen::Vector2d>, const char*>>& dots) {
  const auto width = static_cast<double>(camera.width_px);
  const auto height = static_cast<double>(camera.height_px);
  Plot plot(480, 480 * height / width, {0, -height}, {width, 0}, true);
  plot.Polygon({{0, 0}, {width, 0}, {width, -height}, {0, -height}}, "frame");
  for (const auto& [points_px, css] : dots) {
    std::vector<Eigen::Vector2d> upward;
    // A few thousand dots show as much as all.
    const size_t step = 1 + points_px.size() / 3000;
    for (size_t k = 0; k < points_px.size(); k += step) {
      upward.emplace_back(points_px[k].x(), -points_px[k].y());
    }
    plot.Dots(upward, 0.8, css);
  }
  return "<figure class=\"card\">" + plot.Svg(caption) + "<figcaption>" + caption +
         "</figcaption></figure>";
}

std::string CoverageFigures(const CalibratedRig& record,
                            const calibration::RigObservations& observations) {
  std::vector<Eigen::Vector2d> bw, color, horizontal, vertical;
  const auto append = [](std::vector<Eigen::Vector2d>* to,
                         const std::vector<Eigen::Vector2d>& from) {
    to->insert(to->end(), from.begin(), from.end());
  };
  for (const BoardView& view : observations.views) {
    append(&bw, view.stripe_corners_px);
    append(&color, view.color_corners_px);
    append(&horizontal, view.horizontal_px);
    append(&vertical, view.vertical_px);
  }
  const geometry::SensorRig& rig = record.rig;
  return "<div class=\"stripes\">" +
         Coverage(rig.stripe_camera, "B/W camera: corners", {{bw, "target"}}) +
         Coverage(rig.color_camera, "colour camera: corners", {{color, "target"}}) +
         Coverage(rig.stripe_camera, "B/W camera: stripes, horizontal blue, vertical orange",
                  {{horizontal, "spot horizontal"}, {vertical, "spot vertical"}}) +
         "</div>";
}

std::string EstimateTable(const CalibratedRig& record) {
  std::string html =
      "<table><tr><th>part</th><th>quantity</th><th class=\"number\">off the drawing by</th><th "
      "class=\"number\">one standard deviation</th><th>told by</th></tr>";
  for (const geometry::RigEstimate& estimate : record.estimates) {
    const std::string unit = estimate.unit.empty() ? "" : " " + estimate.unit;
    html += "<tr>" + Cell(Escape(estimate.part)) + Cell(Escape(estimate.what)) +
            NumberCell(Fixed(estimate.difference, 4) + unit) +
            NumberCell(Fixed(estimate.sigma, 4) + unit) +
            Cell(estimate.weak ? "<span class=\"warn\">the drawing</span>" : "the pictures") +
            "</tr>";
  }
  return html + "</table>";
}

std::string FloorText(const calibration::RigCalibration& found) {
  if (!found.floor) {
    return "<p>There were no pictures of the floor: height, roll and pitch of the head stay as "
           "drawn.</p>";
  }
  const calibration::FloorFit& floor = *found.floor;
  return "<p>" + std::to_string(floor.points) + " points of the horizontal stripe lie within " +
         Fixed(1000.0 * floor.rms_m, 1) + " mm rms of one plane. The head stands " +
         Fixed(1000.0 * floor.height_m, 1) + " mm higher than drawn; the floor rises forward by " +
         Fixed(DegreesFromRadians(floor.pitch_rad), 2) + "° and to the left by " +
         Fixed(DegreesFromRadians(floor.roll_rad), 2) + "° against the drawing.</p>";
}

constexpr const char* kFixed =
    "<ul><li>The zeros of both encoders: the head's frame is where they read 0, and the cameras "
    "and "
    "lasers are placed in it.</li><li>The height of the frame along the pan axis (that of the tilt "
    "axis), and its direction about it (square to the tilt axis).</li><li>Where the head stands on "
    "the robot (x, y, yaw): as drawn. No board and no floor can tell it.</li><li>Where in its "
    "plane a "
    "laser's fan starts: as drawn.</li></ul>";

}  // namespace

std::string WeakInWords(const CalibratedRig& record) {
  std::string list;
  for (const geometry::RigEstimate& estimate : record.estimates) {
    if (!estimate.weak) continue;
    list += (list.empty() ? "" : "; ") + estimate.part + ": " + estimate.what + " (" +
            Fixed(estimate.sigma, 3) + (estimate.unit.empty() ? "" : " " + estimate.unit) + ")";
  }
  if (list.empty()) return "Every unknown is told by the pictures.";
  return "Told by the drawing more than by the pictures: " + list +
         ". More stops, nearer and farther, and a board that fills more of the picture would tell "
         "them.";
}

std::string CalibrationPage(const CalibratedRig& record, const calibration::RigCalibration& found,
                            const calibration::RigObservations& observations) {
  const std::string body =
      "<h1>Range known to " + Fixed(1000.0 * RangeSigmaAt(record, 1.0), 2) +
      " mm at 1 m</h1><p class=\"lead\">One standard deviation of the error that all points at "
      "that "
      "distance share, as the fit itself predicts it. Calibrated " +
      Escape(record.date) + ".</p>" + Facts(record) + "<h2>Range</h2>" + RangeTable(record) +
      "<h2>How well it fits</h2>" + ResidualTable(record) +
      "<h2>Where the board was seen</h2><p class=\"muted\">What was never in a corner of the "
      "picture "
      "tells nothing about the lens there.</p>" +
      CoverageFigures(record, observations) + "<h2>What is weakly observed</h2><p>" +
      Escape(WeakInWords(record)) + "</p><h2>The floor</h2>" + FloorText(found) +
      "<h2>Every unknown</h2>" + EstimateTable(record) + "<h2>What is fixed, not estimated</h2>" +
      kFixed + "<footer>Written by geon calibrate rig.</footer>";
  return std::string(
             "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta "
             "name=\"viewport\" content=\"width=device-width\"><title>geonbot calibration: "
             "rig</title><style>") +
         kReportStyle + kExperimentStyle + "</style></head><body><main>" + body +
         "</main></body></html>\n";
}

}  // namespace geon::cli
