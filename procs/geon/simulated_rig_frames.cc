#include "procs/geon/simulated_rig_frames.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/angles.h"
#include "procs/lockstep/frame_image.h"
#include "sim/rig_renderer.h"
#include "sim/world.h"
#include "sim/world_scene.h"

namespace geon::cli {
namespace {

using calibration::Chessboard;
using geometry::RigidTransform;
using geometry::SensorRig;

constexpr double kNearest_m = 0.8;
constexpr double kFarthest_m = 1.8;
constexpr double kBoardMiddle_m = 0.85;  // above the floor: what the level head sees at 1.3 m
const Eigen::Vector2d kBoard_W(4.0, 3.0);

// Where the robot stands and where its head points, for one shot.
struct Aim {
  int stop = 0;
  RigidTransform X_WR = RigidTransform::Identity();
  double pan_rad = 0.0, tilt_rad = 0.0;
};

// A room with the board facing along -x, leaning back so that the head looks at it squarely.
sim::World Room(const Chessboard& board) {
  sim::World world;
  world.pen_size_m = {6.0, 6.0};
  world.lighting.lamp_W_m = {2.5, 3.0, 2.8};
  sim::ChessboardShape sheet;
  sheet.columns = board.columns + 1;
  sheet.rows = board.rows + 1;
  sheet.square_m = board.square_m;
  sheet.margin_m = board.square_m;
  sheet.pitch_rad = RadiansFromDegrees(15.0);
  sim::WorldObject stand;
  stand.shape = sheet;
  stand.color_rgb = {235, 235, 235};
  stand.x_m = kBoard_W.x();
  stand.y_m = kBoard_W.y();
  stand.z_m = kBoardMiddle_m - 0.5 * board.square_m * (board.rows + 3);
  stand.yaw_rad = kPi;
  world.objects.push_back(stand);
  return world;
}

// What the unit's counter says: whole counts only.
double Counted(double angle_rad, const sim::SimOptions& options) {
  const double count_rad = RadiansFromDegrees(options.ptu.unit.resolution_arcsec / 3600.0);
  return count_rad * std::round(angle_rad / count_rad);
}

// Pan and tilt that bring a point of R to the middle between both cameras' pictures.
Aim Centred(const Eigen::Vector3d& p_R, const SensorRig& drawn) {
  const Eigen::Vector3d p_P = drawn.X_RP.inverse() * p_R;
  const double camera_up_m = 0.5 * (drawn.X_TB.translation().z() + drawn.X_TC.translation().z());
  Aim aim;
  aim.pan_rad = std::atan2(p_P.y(), p_P.x());
  aim.tilt_rad = std::atan2(p_P.z(), p_P.head<2>().norm()) - std::asin(camera_up_m / p_P.norm());
  return aim;
}

// How far the head may turn from there until the board's corners leave the smaller picture.
Eigen::Vector2d Reach(double distance_m, const Chessboard& board, const SensorRig& drawn) {
  const geometry::PinholeCamera& camera = drawn.stripe_camera;
  constexpr double kMargin_px = 25.0;
  const auto reach = [&](double half_px, double half_board_m) {
    const double free_px = half_px - kMargin_px - camera.fx_px * half_board_m / distance_m;
    return std::max(0.0, std::atan(free_px / camera.fx_px));
  };
  // Up and down, the two cameras lie half their distance off the middle.
  const double apart_m = 0.5 * (drawn.X_TC.translation().z() - drawn.X_TB.translation().z());
  return {reach(0.5 * camera.width_px, 0.5 * board.square_m * board.columns),
          reach(0.5 * camera.height_px, 0.5 * board.square_m * board.rows + apart_m)};
}

double Between(double low, double high, int k, int count) {
  return count < 2 ? 0.5 * (low + high) : low + (high - low) * k / (count - 1);
}

std::vector<Aim> PlanSweep(const SensorRig& drawn, const sim::SimOptions& options,
                           const Chessboard& board, const RigSweepOptions& sweep) {
  std::vector<Aim> aims;
  const auto add = [&](Aim aim, double pan_rad, double tilt_rad) {
    aim.pan_rad = Counted(aim.pan_rad + pan_rad, options);
    aim.tilt_rad = Counted(aim.tilt_rad + tilt_rad, options);
    aims.push_back(aim);
  };
  const Eigen::Vector3d board_W(kBoard_W.x(), kBoard_W.y(), kBoardMiddle_m);
  constexpr double kBearings_deg[] = {0.0, 28.0, -28.0, 18.0, -18.0};
  for (int stop = 0; stop < sweep.stops; ++stop) {
    const double distance_m = Between(kNearest_m, kFarthest_m, stop, sweep.stops);
    const double bearing_rad = RadiansFromDegrees(kBearings_deg[stop % 5]);
    const double height_m = drawn.X_RP.translation().z() - kBoardMiddle_m;
    const double along_m = std::sqrt(std::max(0.01, distance_m * distance_m - height_m * height_m));
    const RigidTransform X_WR =
        geometry::PlanarPose(kBoard_W.x() - along_m * std::cos(bearing_rad),
                             kBoard_W.y() - along_m * std::sin(bearing_rad), bearing_rad);
    Aim middle = Centred(X_WR.inverse() * board_W, drawn);
    middle.stop = stop;
    middle.X_WR = X_WR;
    const Eigen::Vector2d reach_rad = Reach(distance_m, board, drawn);
    for (int row = 0; row < sweep.rows; ++row) {
      for (int column = 0; column < sweep.columns; ++column) {
        add(middle, Between(-reach_rad.x(), reach_rad.x(), column, sweep.columns),
            Between(-reach_rad.y(), reach_rad.y(), row, sweep.rows));
      }
    }
  }
  Aim floor;
  floor.stop = RigShot::kFloor;
  floor.X_WR = geometry::PlanarPose(3.0, 3.0, kPi);
  for (const double tilt_deg : {-30.0, -35.0, -40.0, -45.0}) {
    for (const double pan_deg : {-35.0, 0.0, 35.0}) {
      add(floor, RadiansFromDegrees(pan_deg), RadiansFromDegrees(tilt_deg));
    }
  }
  return aims;
}

}  // namespace

Status RigSweepOptions::Validate() const {
  if (stops < 1 || columns < 1 || rows < 1) {
    return Status::Error("stops and head poses must be at least 1");
  }
  if (!(exposure_s >= 0.001 && exposure_s <= 2.0)) {
    return Status::Error("the exposure must be from 1 ms to 2 s");
  }
  return Status::Ok();
}

RigSeries SimulatedRig(const SensorRig& drawn, const sim::SimOptions& options,
                       const Chessboard& board, const RigSweepOptions& sweep, uint64_t seed) {
  const Status valid = sweep.Validate();
  Require(valid.ok(), "SimulatedRig: " + valid.message());
  const auto scene = sim::BuildScene(Room(board));
  Require(scene.ok(), "SimulatedRig: " + scene.message());
  const auto renderer = std::make_shared<sim::RigRenderer>(*scene, drawn, options.renderer, seed);
  const std::vector<Aim> aims = PlanSweep(drawn, options, board, sweep);
  const double short_s = 1e-6 * options.renderer.stripe.exposure_us;
  const double color_s = 1e-6 * options.renderer.color.exposure_us;
  const double long_s = sweep.exposure_s;

  RigSeries series;
  series.shots = static_cast<int>(aims.size());
  series.at = [=](int k) -> Result<RigShot> {
    using Camera = RigFrame::Camera;
    using Light = RigFrame::Light;
    const Aim& aim = aims[static_cast<size_t>(k)];
    RigShot shot{aim.stop, aim.pan_rad, aim.tilt_rad, {}};
    const sim::RigPose pose{aim.X_WR, aim.pan_rad, aim.tilt_rad};
    int64_t seq = 10 * (static_cast<int64_t>(k) + 1);
    const auto stripe_frame = [&](Light light, double exposure_s) {
      sim::LaserFractions burning;
      burning.horizontal_1 = light == Light::kHorizontal ? 1.0 : 0.0;
      burning.vertical_1 = light == Light::kVertical ? 1.0 : 0.0;
      shot.frames.push_back(
          {Camera::kStripe, light, exposure_s,
           lockstep::ImageOf(renderer->HeadBw(pose, burning, ++seq, exposure_s / short_s)), ""});
    };
    stripe_frame(Light::kNone, short_s);
    stripe_frame(Light::kHorizontal, short_s);
    if (aim.stop == RigShot::kFloor) return shot;
    stripe_frame(Light::kVertical, short_s);
    stripe_frame(Light::kNone, long_s);
    shot.frames.push_back({Camera::kColor, Light::kNone, color_s,
                           lockstep::ImageOf(renderer->HeadColor(pose, ++seq)), ""});
    return shot;
  };
  return series;
}

}  // namespace geon::cli
