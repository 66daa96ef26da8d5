#include "calibration/calibrate_rig.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

namespace geon::calibration {
namespace {

using geometry::LaserMount;
using geometry::SensorRig;
using sensor::Laser;

constexpr const char* kMeasurementNames[] = {
    "corners in the B/W pictures", "corners in the colour pictures", "points of horizontal stripes",
    "points of vertical stripes"};

std::string Number(double value, int decimals) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.*f", decimals, value);
  return text;
}

Status CheckEnough(const RigObservations& observations, const CalibrationOptions& options) {
  std::set<int> stops;
  int views = 0;
  int color_views = 0;
  size_t points[2] = {0, 0};
  for (const BoardView& view : observations.views) {
    color_views += view.color_corners_px.empty() ? 0 : 1;
    points[0] += view.horizontal_px.size();
    points[1] += view.vertical_px.size();
    if (view.stripe_corners_px.empty()) continue;
    ++views;
    stops.insert(view.stop);
  }
  const Chessboard& board = observations.board;
  const std::string size = std::to_string(board.columns) + " x " + std::to_string(board.rows);
  if (views == 0) {
    return Status::Error("the board was not seen: no B/W picture of " +
                         std::to_string(observations.views.size()) + " shows all its " + size +
                         " inner corners; check the number of squares, the light and the exposure");
  }
  if (static_cast<int>(stops.size()) < options.min_stops) {
    return Status::Error("the board was seen from " + std::to_string(stops.size()) +
                         " stop, needed " + std::to_string(options.min_stops) +
                         " at different distances: drive the robot on and sweep again");
  }
  if (views < options.min_views) {
    return Status::Error("too few poses: the B/W camera saw the whole board in " +
                         std::to_string(views) + " pictures, needed " +
                         std::to_string(options.min_views));
  }
  if (color_views < options.min_color_views) {
    return Status::Error("too few poses: the colour camera saw the whole board in " +
                         std::to_string(color_views) + " pictures, needed " +
                         std::to_string(options.min_color_views));
  }
  for (const int k : {0, 1}) {
    if (points[k] < static_cast<size_t>(options.min_stripe_points)) {
      return Status::Error(std::string("the ") + (k == 0 ? "horizontal" : "vertical") +
                           " laser left " + std::to_string(points[k]) +
                           " points on the board's white squares, needed " +
                           std::to_string(options.min_stripe_points) + ": is it lit?");
    }
  }
  return Status::Ok();
}

// Views that hold something, of stops that saw the board, numbered from 0.
RigObservations Usable(const RigObservations& all) {
  std::map<int, int> number;
  for (const BoardView& view : all.views) {
    if (!view.stripe_corners_px.empty()) number.emplace(view.stop, 0);
  }
  int next = 0;
  for (auto& [stop, renumbered] : number) renumbered = next++;
  RigObservations usable{all.board, {}, all.floor};
  for (const BoardView& view : all.views) {
    if (number.count(view.stop) == 0) continue;
    if (view.stripe_corners_px.empty() && view.color_corners_px.empty()) continue;
    usable.views.push_back(view);
    usable.views.back().stop = number[view.stop];
  }
  return usable;
}

std::vector<double> StopDistances(const Bundle& bundle, const Chessboard& board,
                                  const SensorRig& rig) {
  std::vector<double> distances_m;
  const Eigen::Vector3d middle_m = 0.5 * board.Corner(board.corners() - 1);
  for (const geometry::RigidTransform& X_PBoard : bundle.boards) {
    distances_m.push_back((X_PBoard * middle_m - rig.X_TB.translation()).norm());
  }
  return distances_m;
}

// From the B/W camera's centre to the fan, along the fan's normal.
double Baseline(const LaserMount& laser, const SensorRig& rig) {
  return laser.normal_T.dot(laser.p_TLaser_m - rig.X_TB.translation());
}

// How much larger the rig's baselines are than the drawing's, by least squares.
double BaselineScale(const SensorRig& rig, const SensorRig& drawn) {
  double product = 0.0;
  double square = 0.0;
  const auto add = [&](double found_m, double drawn_m) {
    product += found_m * drawn_m;
    square += drawn_m * drawn_m;
  };
  add(Baseline(rig.horizontal_laser, rig), Baseline(drawn.horizontal_laser, drawn));
  add(Baseline(rig.vertical_laser, rig), Baseline(drawn.vertical_laser, drawn));
  add((rig.X_TC.translation() - rig.X_TB.translation()).norm(),
      (drawn.X_TC.translation() - drawn.X_TB.translation()).norm());
  return product / square;
}

Status CheckFit(const RigCalibration& found, const SensorRig& drawn, const Chessboard& board,
                const CalibrationOptions& options) {
  const double off_1 = found.baseline_scale_1 - 1.0;
  if (std::abs(off_1) > options.max_scale_error_1) {
    return Status::Error(
        "the squares have another size than said: with " + Number(1000.0 * board.square_m, 2) +
        " mm the lasers and cameras would sit " + Number(100.0 * std::abs(off_1), 1) + " % " +
        (off_1 > 0.0 ? "farther apart" : "closer together") +
        " than drawn; measure a row of squares (about " +
        Number(1000.0 * board.square_m / found.baseline_scale_1, 1) + " mm each would fit)");
  }
  const auto nearest =
      std::minmax_element(found.stop_distances_m.begin(), found.stop_distances_m.end());
  if (*nearest.second < options.min_distance_ratio_1 * *nearest.first) {
    return Status::Error("all stops are at about one distance from the board, " +
                         Number(*nearest.first, 2) + " to " + Number(*nearest.second, 2) +
                         " m: take some nearer and some farther, 0.8 to 1.8 m");
  }
  const auto check_focal = [&](const char* camera, double found_px, double drawn_px) {
    if (std::abs(found_px / drawn_px - 1.0) <= options.max_focal_error_1) return Status::Ok();
    return Status::Error(
        std::string("the ") + camera + " camera's focal length comes out as " +
        Number(found_px, 0) + " px, drawn are " + Number(drawn_px, 0) +
        " px: are the angles those of the pictures, and the lens that of the drawing?");
  };
  Status status = check_focal("B/W", found.rig.stripe_camera.fx_px, drawn.stripe_camera.fx_px);
  if (!status.ok()) return status;
  status = check_focal("colour", found.rig.color_camera.fx_px, drawn.color_camera.fx_px);
  if (!status.ok()) return status;
  for (size_t k = 0; k < kMeasurements; ++k) {
    const double limit_px = k < 2 ? options.max_corner_rms_px : options.max_stripe_rms_px;
    if (found.residuals[k].rms_px <= limit_px) continue;
    return Status::Error(std::string("the ") + kMeasurementNames[k] +
                         " do not fit: " + Number(found.residuals[k].rms_px, 2) +
                         " px rms, at most " + Number(limit_px, 2) +
                         "; the board must be flat and still, the head must stand, and every "
                         "picture must carry its own angles");
  }
  return Status::Ok();
}

// Range along the B/W camera's axis at the pixel in the middle of the stripe that the found rig
// would show at `distance_m`, as the unknowns change.
double RangeAt(const RigUnknowns& unknowns, const SensorRig& drawn, Laser which,
               const Eigen::Vector2d& pixel_px) {
  const SensorRig rig = RigFrom(unknowns, drawn);
  const LaserMount& laser = which == Laser::kVertical ? rig.vertical_laser : rig.horizontal_laser;
  return rig.DistanceToFan(laser, rig.stripe_camera.Ray(pixel_px.x(), pixel_px.y()));
}

Eigen::Vector2d StripePixel(const SensorRig& rig, Laser which, double distance_m) {
  const LaserMount& laser = which == Laser::kVertical ? rig.vertical_laser : rig.horizontal_laser;
  // Of the points (x, 0, z) or (0, y, z) of the camera at that depth, the one in the fan.
  const Eigen::Vector3d normal_B = rig.X_TB.linear().transpose() * laser.normal_T;
  const double rest = Baseline(laser, rig) - normal_B.z() * distance_m;
  const Eigen::Vector3d p_B_m = which == Laser::kVertical
                                    ? Eigen::Vector3d(rest / normal_B.x(), 0.0, distance_m)
                                    : Eigen::Vector3d(0.0, rest / normal_B.y(), distance_m);
  return rig.stripe_camera.Project(p_B_m);
}

std::vector<RangeSigma> RangeSigmas(const Bundle& bundle, const SensorRig& drawn) {
  std::vector<RangeSigma> sigmas;
  const SensorRig rig = RigFrom(bundle.unknowns, drawn);
  for (const Laser laser : {Laser::kHorizontal, Laser::kVertical}) {
    for (const double distance_m : {0.7, 1.0, 1.5, 2.0}) {
      const Eigen::Vector2d pixel_px = StripePixel(rig, laser, distance_m);
      Eigen::Matrix<double, RigUnknowns::kAll, 1> slope;
      for (int k = 0; k < RigUnknowns::kAll; ++k) {
        const double step = 1e-3 * std::max(1e-6, std::sqrt(bundle.covariance(k, k)));
        RigUnknowns moved = bundle.unknowns;
        moved.at(k) += step;
        const double above_m = RangeAt(moved, drawn, laser, pixel_px);
        moved.at(k) -= 2.0 * step;
        slope[k] = (above_m - RangeAt(moved, drawn, laser, pixel_px)) / (2.0 * step);
      }
      sigmas.push_back({laser, distance_m, std::sqrt(slope.dot(bundle.covariance * slope))});
    }
  }
  return sigmas;
}

}  // namespace

Status CalibrationOptions::Validate() const {
  if (min_stops < 1 || min_views < 1) return Status::Error("stops and views must be positive");
  if (!(weak_1 > 0.0 && weak_1 <= 1.0)) return Status::Error("weak_1 must be in (0, 1]");
  return bundle.tolerances.Validate();
}

Result<RigCalibration> CalibrateRig(const RigObservations& observations, const SensorRig& drawn,
                                    const CalibrationOptions& options) {
  Status status = options.Validate();
  if (!status.ok()) throw ContractViolation("CalibrateRig: " + status.message());
  status = CheckEnough(observations, options);
  if (!status.ok()) return status;
  const RigObservations usable = Usable(observations);
  const Result<Bundle> bundle = AdjustRig(usable, drawn, options.bundle);
  if (!bundle.ok()) return bundle.status();

  RigCalibration found;
  found.rig = RigFrom(bundle->unknowns, drawn);
  found.unknowns = bundle->unknowns;
  found.prior_sigma = PriorSigmas(options.bundle.tolerances, drawn);
  found.residuals = bundle->residuals;
  found.stop_distances_m = StopDistances(*bundle, observations.board, found.rig);
  found.baseline_scale_1 = BaselineScale(found.rig, drawn);
  for (const BoardView& view : usable.views) found.views += view.stripe_corners_px.empty() ? 0 : 1;
  status = CheckFit(found, drawn, observations.board, options);
  if (!status.ok()) return status;

  found.range_sigmas = RangeSigmas(*bundle, drawn);
  for (int k = 0; k < RigUnknowns::kAll; ++k) {
    const auto i = static_cast<size_t>(k);
    found.sigma[i] = std::sqrt(bundle->covariance(k, k));
    if (found.sigma[i] > options.weak_1 * found.prior_sigma[i]) found.weak.push_back(k);
  }
  if (!observations.floor.empty()) {
    Result<FloorFit> floor = FitFloor(observations.floor, found.rig, options.floor);
    if (!floor.ok()) return floor.status().In("floor");
    found.rig.X_RP = floor->X_RP;
    found.floor = *std::move(floor);
  }
  return found;
}

geometry::CalibratedRig RecordOf(const RigCalibration& calibration, const std::string& date) {
  geometry::CalibratedRig record;
  record.rig = calibration.rig;
  record.date = date;
  record.stops = static_cast<int>(calibration.stop_distances_m.size());
  record.views = calibration.views;
  for (size_t k = 0; k < kMeasurements; ++k) {
    const Residuals& residuals = calibration.residuals[k];
    record.residuals.push_back(
        {kMeasurementNames[k], residuals.count, residuals.rms_px, residuals.outliers});
  }
  for (const RangeSigma& range : calibration.range_sigmas) {
    record.range_sigmas.push_back(
        {std::string(ToString(range.laser)), range.distance_m, range.sigma_m});
  }
  for (int k = 0; k < RigUnknowns::kAll; ++k) {
    const auto i = static_cast<size_t>(k);
    const UnknownName& name = UnknownNames()[i];
    const bool weak =
        std::find(calibration.weak.begin(), calibration.weak.end(), k) != calibration.weak.end();
    record.estimates.push_back({name.part, name.what, name.unit,
                                name.display_1 * calibration.unknowns.at(k),
                                name.display_1 * calibration.sigma[i], weak});
  }
  return record;
}

}  // namespace geon::calibration
