#include "config/rig_config.h"

#include <array>

#include "base/angles.h"
#include "config/calibrated_rig_file.h"
#include "config/daemon_arguments.h"
#include "config/text_file.h"

namespace geon::config {

namespace {

using geometry::CameraAxesInBody;
using geometry::LaserMount;
using geometry::MakeTransform;
using geometry::PinholeCamera;
using geometry::RigidTransform;
using geometry::RotationAboutY;

Eigen::Vector3d ReadPosition(YamlSection& section) {
  std::array<double, 3> position_m{};
  section.ReadNumbers("position_m", 3, position_m.data());
  return {position_m[0], position_m[1], position_m[2]};
}

double ReadPitchDown(YamlSection& section) {
  double pitch_down_rad = 0.0;
  section.ReadAngle("pitch_down_deg", &pitch_down_rad);
  section.Check(std::abs(pitch_down_rad) <= kPi / 2, "pitch_down_deg", "must be within +-90");
  return pitch_down_rad;
}

PinholeCamera ReadCamera(YamlSection& section) {
  PinholeCamera camera;
  section.Read("width_px", &camera.width_px);
  section.Read("height_px", &camera.height_px);
  section.Read("focal_px", &camera.fx_px);
  section.Check(camera.width_px >= 16 && camera.width_px <= 8192, "width_px", "must be 16..8192");
  section.Check(camera.height_px >= 16 && camera.height_px <= 8192, "height_px",
                "must be 16..8192");
  section.Check(camera.fx_px > 0.0, "focal_px", "must be positive");
  camera.fy_px = camera.fx_px;
  camera.cx_px = (camera.width_px - 1) / 2.0;
  camera.cy_px = (camera.height_px - 1) / 2.0;
  return camera;
}

// The fan holds the laser, the direction of its stripe and the point where it crosses the optical
// axis of the B/W camera. `upward` is the side the normal points to.
LaserMount ReadLaser(YamlSection section, const Eigen::Vector3d& p_TB_m,
                     const Eigen::Vector3d& stripe_direction_T, const Eigen::Vector3d& upward_T) {
  LaserMount laser;
  laser.p_TLaser_m = ReadPosition(section);
  double crosses_axis_m = 1.0;
  section.Read("crosses_axis_m", &crosses_axis_m);
  section.Check(crosses_axis_m > 0.0, "crosses_axis_m", "must be positive");
  const Eigen::Vector3d crossing_T = p_TB_m + Eigen::Vector3d(crosses_axis_m, 0.0, 0.0);
  const Eigen::Vector3d normal_T = stripe_direction_T.cross(crossing_T - laser.p_TLaser_m);
  const bool is_plane = normal_T.norm() > 1e-9;
  section.Check(is_plane, "position_m", "leaves no plane through the point on the axis");
  if (!is_plane) return laser;
  laser.normal_T = normal_T.normalized();
  if (laser.normal_T.dot(upward_T) < 0.0) laser.normal_T = -laser.normal_T;
  return laser;
}

}  // namespace

geometry::SensorRig ReadDrawnRig(YamlSection rig) {
  geometry::SensorRig result;
  rig.Ignore("calibrated");

  YamlSection ptu = rig.Child("ptu");
  const Eigen::Vector3d p_RP_m = ReadPosition(ptu);
  result.X_RP = MakeTransform(RotationAboutY(ReadPitchDown(ptu)), p_RP_m);

  YamlSection color = rig.Child("color_camera");
  result.X_TC = MakeTransform(CameraAxesInBody(), ReadPosition(color));
  result.color_camera = ReadCamera(color);

  YamlSection stripe = rig.Child("stripe_camera");
  const Eigen::Vector3d p_TB_m = ReadPosition(stripe);
  result.X_TB = MakeTransform(CameraAxesInBody(), p_TB_m);
  result.stripe_camera = ReadCamera(stripe);

  const Eigen::Vector3d left_T = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d up_T = Eigen::Vector3d::UnitZ();
  result.horizontal_laser = ReadLaser(rig.Child("horizontal_laser"), p_TB_m, left_T, up_T);
  result.vertical_laser = ReadLaser(rig.Child("vertical_laser"), p_TB_m, up_T, left_T);

  YamlSection floor = rig.Child("floor_camera");
  const Eigen::Vector3d p_RF_m = ReadPosition(floor);
  result.X_RF = MakeTransform(RotationAboutY(ReadPitchDown(floor)) * CameraAxesInBody(), p_RF_m);
  result.floor_camera = ReadCamera(floor);
  return result;
}

RobotRig ReadRobotRig(YamlSection rig, const std::filesystem::path& robot_file) {
  RobotRig result;
  result.rig = ReadDrawnRig(rig);
  if (!rig.Has("calibrated")) return result;
  std::string name;
  rig.Read("calibrated", &name);
  const std::filesystem::path file = robot_file.parent_path() / name;
  const auto refuse = [&](const Status& status) { rig.Fail("calibrated: " + status.message()); };
  const Result<std::string> text = ReadFile(file, 1U << 20U);
  if (!text.ok()) {
    refuse(Status::Error(text.message() + "; make it by geon calibrate rig, or leave the key out"));
    return result;
  }
  const Result<geometry::CalibratedRig> calibrated =
      ParseCalibratedRig(*text, file.string(), result.rig);
  if (!calibrated.ok()) {
    refuse(calibrated.status());
    return result;
  }
  const Status plausible = CheckAgainstDrawing(calibrated->rig, result.rig).In(file.string());
  if (!plausible.ok()) {
    refuse(plausible);
    return result;
  }
  result.rig = calibrated->rig;
  result.hash = FileHash(file);
  result.source = "calibrated " + calibrated->date + " (" + file.string() + ")";
  return result;
}

}  // namespace geon::config
