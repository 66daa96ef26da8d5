#pragma once

#include <Eigen/Geometry>
#include <random>

#include "base/angles.h"
#include "calibration/rig_observations.h"
#include "geometry/sensor_rig.h"

namespace geon::calibration {

// A robot for tests, with its own geometry: hinges in space, 4x4 matrices and planes, nothing of
// the room under test or of geometry::SensorRig. It measures boards with Gaussian noise.
class SyntheticRobot {
 public:
  struct Camera {
    Eigen::Matrix4d head_from_camera = Eigen::Matrix4d::Identity();
    double f = 1600.0, aspect = 1.0, cu = 319.5, cv = 239.5, k1 = 0.0, k2 = 0.0;
  };
  // What is off its drawing, in the drawing's head frame.
  double pan_zero = RadiansFromDegrees(0.2), tilt_zero = RadiansFromDegrees(-0.15);
  Eigen::Vector3d tilt_axis = Eigen::Vector3d(0.002, 1.0, 0.0015).normalized();
  Eigen::Vector3d tilt_axis_point = {0.0015, 0.0, -0.001};
  Camera bw, color;
  Eigen::Vector4d horizontal_fan, vertical_fan;  // n and d of n . p = d
  double corner_noise = 0.05, stripe_noise = 0.08, ptu_noise = 0.0;
  double square = 0.02;  // of the board as it is

  SyntheticRobot() {
    bw.head_from_camera = Mounted({0.0512, -0.0008, 0.0441}, {0.004, -0.003, 0.005});
    bw.f = 1612.0, bw.aspect = 1.001, bw.cu = 324.0, bw.cv = 235.0, bw.k1 = -0.09, bw.k2 = 0.1;
    color.head_from_camera = Mounted({0.0493, 0.0011, 0.1108}, {-0.003, 0.002, -0.004});
    color.f = 1590.0, color.cu = 316.0, color.cv = 243.0, color.k1 = 0.06;
    // Both fans cross the drawn axis of the B/W camera near 1.04 m.
    horizontal_fan = Fan({0.0505, 0.0, 0.1709}, {1.085, 0.0, 0.047}, {0.0, 1.0, 0.004});
    vertical_fan = Fan({0.0498, 0.1241, 0.045}, {1.088, 0.003, 0.045}, {0.003, 0.0, 1.0});
  }

  // A board whose axes are `board` in the pan-tilt unit's frame, seen at the encoders' angles.
  BoardView Look(const Chessboard& told, const Eigen::Matrix4d& board, int stop, double pan,
                 double tilt, std::mt19937_64* random) const {
    std::normal_distribution<double> gauss;
    const double pan_true = pan + ptu_noise * gauss(*random);
    const double tilt_true = tilt + ptu_noise * gauss(*random);
    BoardView view{stop, pan, tilt, {}, {}, {}, {}};
    const Eigen::Matrix4d head_from_board = HeadInBase(pan_true, tilt_true).inverse() * board;
    for (const auto& [camera, corners] :
         {std::pair(&bw, &view.stripe_corners_px), std::pair(&color, &view.color_corners_px)}) {
      for (int k = 0; k < told.corners(); ++k) {
        const Eigen::Vector4d corner(square * (k % told.columns), square * (k / told.columns), 0.0,
                                     1.0);
        const Eigen::Vector2d seen = Picture(*camera, (head_from_board * corner).head<3>());
        corners->push_back(seen + corner_noise * Eigen::Vector2d(gauss(*random), gauss(*random)));
        if (!(seen.x() > 0 && seen.x() < 639 && seen.y() > 0 && seen.y() < 479)) {
          corners->clear();
          break;
        }
      }
    }
    if (view.stripe_corners_px.empty()) return view;
    const double width = square * (told.columns - 1);
    const double height = square * (told.rows - 1);
    for (int k = 0; k < 60; ++k) {
      // Where the fan cuts a line drawn on the board.
      const double share = k / 59.0;
      if (const auto p =
              Cut(horizontal_fan, head_from_board, {share * width, 0.0}, {share * width, height})) {
        view.horizontal_px.push_back(Picture(bw, *p) +
                                     Eigen::Vector2d(0.0, stripe_noise * gauss(*random)));
      }
      if (const auto p =
              Cut(vertical_fan, head_from_board, {0.0, share * height}, {width, share * height})) {
        view.vertical_px.push_back(Picture(bw, *p) +
                                   Eigen::Vector2d(stripe_noise * gauss(*random), 0.0));
      }
    }
    return view;
  }

  // The head in the unit's frame: a turn about the vertical hinge after one about the tilt hinge.
  Eigen::Matrix4d HeadInBase(double pan, double tilt) const {
    Eigen::Matrix4d tilted = Eigen::Matrix4d::Identity();
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(-(tilt + tilt_zero), tilt_axis).toRotationMatrix();
    tilted.topLeftCorner<3, 3>() = turn;
    tilted.topRightCorner<3, 1>() = tilt_axis_point - turn * tilt_axis_point;
    Eigen::Matrix4d panned = Eigen::Matrix4d::Identity();
    panned.topLeftCorner<3, 3>() =
        Eigen::AngleAxisd(pan + pan_zero, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    return panned * tilted;
  }

  // Where the B/W camera sees a point that lies in the fan at depth z, near the picture's middle:
  // on the line u = given (horizontal) or v = given (vertical). Found by search.
  Eigen::Vector2d SeenInFan(bool horizontal, double line_px, double depth) const {
    const Eigen::Vector4d& fan = horizontal ? horizontal_fan : vertical_fan;
    double low = -200.0;
    double high = 840.0;
    const auto over = [&](double across) {
      const Eigen::Vector2d pixel =
          horizontal ? Eigen::Vector2d(line_px, across) : Eigen::Vector2d(across, line_px);
      const Eigen::Vector4d p_camera =
          (Eigen::Vector4d() << depth * Ideal(bw, pixel), 1.0).finished();
      return fan.head<3>().dot((bw.head_from_camera * p_camera).head<3>()) - fan[3];
    };
    const bool rising = over(high) > over(low);
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      ((over(middle) > 0.0) == rising ? high : low) = middle;
    }
    return horizontal ? Eigen::Vector2d(line_px, low) : Eigen::Vector2d(low, line_px);
  }

 private:
  static Eigen::Matrix4d Mounted(const Eigen::Vector3d& p, const Eigen::Vector3d& turn) {
    Eigen::Matrix4d mounted = Eigen::Matrix4d::Identity();
    Eigen::Matrix3d axes;
    axes << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    mounted.topLeftCorner<3, 3>() =
        Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * axes;
    mounted.topRightCorner<3, 1>() = p;
    return mounted;
  }
  static Eigen::Vector4d Fan(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                             const Eigen::Vector3d& along) {
    Eigen::Vector4d fan;
    fan.head<3>() = (b - a).cross(along).normalized();
    fan[3] = fan.head<3>().dot(a);
    return fan;
  }
  static Eigen::Vector2d Picture(const Camera& camera, const Eigen::Vector3d& p_head) {
    const Eigen::Vector4d p = camera.head_from_camera.inverse() * p_head.homogeneous();
    const double x = p[0] / p[2];
    const double y = p[1] / p[2];
    const double r2 = x * x + y * y;
    const double warp = 1.0 + camera.k1 * r2 + camera.k2 * r2 * r2;
    return {camera.cu + camera.f * x * warp, camera.cv + camera.f * camera.aspect * y * warp};
  }
  // The ray (z = 1) of a pixel, by halving the radius' interval.
  static Eigen::Vector3d Ideal(const Camera& camera, const Eigen::Vector2d& pixel) {
    const Eigen::Vector2d seen((pixel.x() - camera.cu) / camera.f,
                               (pixel.y() - camera.cv) / (camera.f * camera.aspect));
    double low = 0.5;
    double high = 2.0;
    for (int k = 0; k < 60; ++k) {
      const double scale = (low + high) / 2;
      const double r2 = scale * scale * seen.squaredNorm();
      (scale * (1.0 + camera.k1 * r2 + camera.k2 * r2 * r2) > 1.0 ? high : low) = scale;
    }
    return {low * seen.x(), low * seen.y(), 1.0};
  }
  static std::optional<Eigen::Vector3d> Cut(const Eigen::Vector4d& fan,
                                            const Eigen::Matrix4d& head_from_board,
                                            const Eigen::Vector2d& from,
                                            const Eigen::Vector2d& to) {
    const auto in_head = [&](const Eigen::Vector2d& p) -> Eigen::Vector3d {
      return (head_from_board * Eigen::Vector4d(p.x(), p.y(), 0.0, 1.0)).head<3>();
    };
    const Eigen::Vector3d a = in_head(from);
    const Eigen::Vector3d b = in_head(to);
    const double over_a = fan.head<3>().dot(a) - fan[3];
    const double over_b = fan.head<3>().dot(b) - fan[3];
    if (over_a * over_b > 0.0) return std::nullopt;
    return (over_b * a - over_a * b) / (over_b - over_a);
  }
};

// The rig as drawn: scripts/config/robot.yaml's figures.
inline geometry::SensorRig DrawnRig() {
  using geometry::CameraAxesInBody;
  using geometry::MakeTransform;
  geometry::SensorRig rig;
  rig.X_RP = MakeTransform(geometry::RotationAboutY(RadiansFromDegrees(15.0)), {0.0, 0.0, 1.2});
  rig.X_TC = MakeTransform(CameraAxesInBody(), {0.05, 0.0, 0.110});
  rig.X_TB = MakeTransform(CameraAxesInBody(), {0.05, 0.0, 0.045});
  const Eigen::Vector3d crossing_T(1.087, 0.0, 0.045);
  const auto laser = [&](const Eigen::Vector3d& p_T, const Eigen::Vector3d& stripe_T) {
    return geometry::LaserMount{p_T, stripe_T.cross(p_T - crossing_T).normalized()};
  };
  rig.horizontal_laser = laser({0.05, 0.0, 0.170}, -Eigen::Vector3d::UnitY());
  rig.vertical_laser = laser({0.05, 0.125, 0.045}, Eigen::Vector3d::UnitZ());
  return rig;
}

// A board from `stops` places between 0.8 and 1.8 m, seen at columns x rows of head angles each.
inline RigObservations LookAround(const SyntheticRobot& robot, int stops, int columns, int rows,
                                  uint64_t seed) {
  RigObservations observations;
  std::mt19937_64 random(seed);
  const Chessboard& board = observations.board;
  for (int stop = 0; stop < stops; ++stop) {
    const double depth = 0.8 + (stops > 1 ? 1.0 * stop / (stops - 1) : 0.0);
    const double slant = 0.4 * (stop % 3 - 1);
    // The board's axes (right, down, away) in the unit's, its middle `depth` ahead.
    Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
    Eigen::Matrix3d axes;
    axes << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    pose.topLeftCorner<3, 3>() =
        Eigen::AngleAxisd(slant, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
        Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()).toRotationMatrix() * axes;
    const Eigen::Vector3d middle(0.5 * robot.square * (board.columns - 1),
                                 0.5 * robot.square * (board.rows - 1), 0.0);
    pose.topRightCorner<3, 1>() =
        Eigen::Vector3d(depth, 0.0, 0.06) - pose.topLeftCorner<3, 3>() * middle;
    const double reach = depth < 1.1 ? 0.06 : 0.11;
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j < rows; ++j) {
        observations.views.push_back(
            robot.Look(board, pose, stop, reach * (2.0 * i / (columns - 1) - 1.0),
                       0.7 * reach * (2.0 * j / (rows - 1) - 1.0), &random));
      }
    }
  }
  return observations;
}

}  // namespace geon::calibration
