#include "config/calibrated_rig_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/angles.h"
#include "config/text_file.h"
#include "config/yaml_section.h"

namespace geon::config {
namespace {

using geometry::CalibratedRig;
using geometry::LaserMount;
using geometry::PinholeCamera;
using geometry::RigidTransform;
using geometry::SensorRig;

constexpr const char* kRigFormat = "geon.rig.v1";
constexpr std::string_view kRigHashKey = "fnv1a: ";

// The shortest text that reads back as the same number.
std::string Exactly(double number) {
  std::array<char, 40> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  return {buffer.data(), end};
}

template <typename Values>
std::string List(const Values& values) {
  std::string text = "[";
  for (const double value : values) text += (text.size() > 1 ? ", " : "") + Exactly(value);
  return text + "]";
}

std::string Pose(const char* frames, const RigidTransform& X) {
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rotation = X.linear();
  return "position_m: " + List(X.translation()) + ",\n   rotation_" + frames + ": " +
         List(rotation.reshaped<Eigen::RowMajor>());
}

std::string Camera(const char* frames, const RigidTransform& X, const PinholeCamera& camera) {
  return "\n  {" + Pose(frames, X) + ",\n   width_px: " + std::to_string(camera.width_px) +
         ", height_px: " + std::to_string(camera.height_px) +
         ",\n   focal_px: " + List(std::array{camera.fx_px, camera.fy_px}) +
         ", center_px: " + List(std::array{camera.cx_px, camera.cy_px}) +
         ", k1_1: " + Exactly(camera.k1_1) + ", k2_1: " + Exactly(camera.k2_1) + "}\n";
}

std::string Fan(const LaserMount& laser) {
  return "\n  {position_m: " + List(laser.p_TLaser_m) + ", normal_T: " + List(laser.normal_T) +
         "}\n";
}

Eigen::Vector3d ReadVector(YamlSection* section, const char* key) {
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  section->ReadNumbers(key, 3, vector.data());
  return vector;
}

// Text that stands between quotes as it is.
void ReadPlain(YamlSection* section, const char* key, std::string* text) {
  section->Read(key, text);
  const bool plain = std::all_of(text->begin(), text->end(), [](char c) {
    return static_cast<unsigned char>(c) >= 0x20 && c != '"' && c != '\\' && c != 0x7f;
  });
  section->Check(plain, key, "must be one line without quotes and backslashes");
}

RigidTransform ReadPose(YamlSection* section, const char* rotation_key) {
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rotation = Eigen::Matrix3d::Identity();
  section->ReadNumbers(rotation_key, 9, rotation.data());
  const bool is_rotation =
      (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-9 &&
      rotation.determinant() > 0.0;
  section->Check(is_rotation, rotation_key, "must be a rotation matrix, row by row");
  return geometry::MakeTransform(rotation, ReadVector(section, "position_m"));
}

PinholeCamera ReadLens(YamlSection* section) {
  PinholeCamera camera;
  section->Read("width_px", &camera.width_px);
  section->Read("height_px", &camera.height_px);
  section->Check(camera.width_px >= 16 && camera.width_px <= 8192, "width_px", "must be 16..8192");
  section->Check(camera.height_px >= 16 && camera.height_px <= 8192, "height_px",
                 "must be 16..8192");
  std::array<double, 2> focal_px{1600.0, 1600.0};
  section->ReadNumbers("focal_px", 2, focal_px.data());
  section->Check(focal_px[0] > 0.0 && focal_px[1] > 0.0, "focal_px", "must be positive");
  camera.fx_px = focal_px[0];
  camera.fy_px = focal_px[1];
  std::array<double, 2> center_px{};
  section->ReadNumbers("center_px", 2, center_px.data());
  camera.cx_px = center_px[0];
  camera.cy_px = center_px[1];
  section->Read("k1_1", &camera.k1_1);
  section->Read("k2_1", &camera.k2_1);
  section->Check(std::abs(camera.k1_1) <= 2.0, "k1_1", "must be within +-2");
  section->Check(std::abs(camera.k2_1) <= 10.0, "k2_1", "must be within +-10");
  return camera;
}

LaserMount ReadFan(YamlSection section) {
  LaserMount laser;
  laser.p_TLaser_m = ReadVector(&section, "position_m");
  laser.normal_T = ReadVector(&section, "normal_T");
  section.Check(std::abs(laser.normal_T.norm() - 1.0) < 1e-9, "normal_T", "must have length 1");
  return laser;
}

void ReadQuality(YamlSection* root, CalibratedRig* calibrated) {
  for (YamlSection section : root->Children("residuals")) {
    geometry::RigResidual& residual = calibrated->residuals.emplace_back();
    ReadPlain(&section, "what", &residual.what);
    section.Read("count", &residual.count);
    section.Read("rms_px", &residual.rms_px);
    section.Read("outliers", &residual.outliers);
  }
  for (YamlSection section : root->Children("range_sigmas")) {
    geometry::RigRangeSigma& range = calibrated->range_sigmas.emplace_back();
    ReadPlain(&section, "laser", &range.laser);
    section.Read("distance_m", &range.distance_m);
    section.Read("sigma_m", &range.sigma_m);
  }
  for (YamlSection section : root->Children("estimates")) {
    geometry::RigEstimate& estimate = calibrated->estimates.emplace_back();
    ReadPlain(&section, "part", &estimate.part);
    ReadPlain(&section, "what", &estimate.what);
    ReadPlain(&section, "unit", &estimate.unit);
    section.Read("difference", &estimate.difference);
    section.Read("sigma", &estimate.sigma);
    section.Read("weak", &estimate.weak);
  }
}

// The text before the hash's line, if its hash is the one written there.
Status CheckHash(const std::string& text, const std::string& name) {
  const size_t line = text.rfind("\n" + std::string(kRigHashKey));
  if (line == std::string::npos) {
    return Status::Error(name + ": the file does not end in its hash; it was cut off or is no " +
                         std::string(kRigFormat) + " file: calibrate again");
  }
  const std::string written = text.substr(line + 1 + kRigHashKey.size());
  const std::string found = "\"" + ContentHash(text.substr(0, line + 1)) + "\"\n";
  if (written == found) return Status::Ok();
  return Status::Error(
      name + ": its hash is " + found.substr(1, 16) +
      ", not the one on its last "
      "line: it was changed by hand or damaged; calibrate again (geon calibrate rig)");
}

}  // namespace

std::string SerializeCalibratedRig(const CalibratedRig& calibrated) {
  const SensorRig& rig = calibrated.rig;
  std::string text =
      "# Written by geon calibrate rig (docs/calibration.md). Do not edit: the last line is the "
      "hash.\n";
  text += std::string("format: ") + kRigFormat + "\ndate: \"" + calibrated.date + "\"\n";
  text += "stops: " + std::to_string(calibrated.stops) +
          "\nviews: " + std::to_string(calibrated.views) +
          "\n\n# Frames: docs/frames.md. Rotations are row by row.\nptu:\n  {" +
          Pose("RP", rig.X_RP) +
          ",\n   tilt_roll_deg: " + Exactly(DegreesFromRadians(rig.ptu_axes.tilt_roll_rad)) +
          ", tilt_yaw_deg: " + Exactly(DegreesFromRadians(rig.ptu_axes.tilt_yaw_rad)) +
          ", tilt_axis_m: " + List(rig.ptu_axes.p_PTilt_m) + "}\n";
  text += "color_camera:" + Camera("TC", rig.X_TC, rig.color_camera);
  text += "stripe_camera:" + Camera("TB", rig.X_TB, rig.stripe_camera);
  text += "horizontal_laser:" + Fan(rig.horizontal_laser);
  text += "vertical_laser:" + Fan(rig.vertical_laser);
  text += "\n# How well it fits: rms without outliers.\nresiduals:\n";
  for (const geometry::RigResidual& residual : calibrated.residuals) {
    text += "  - {what: \"" + residual.what + "\", count: " + std::to_string(residual.count) +
            ", rms_px: " + Exactly(residual.rms_px) +
            ", outliers: " + std::to_string(residual.outliers) + "}\n";
  }
  text += "# What a range is off by for all points there, standard deviation.\nrange_sigmas:\n";
  for (const geometry::RigRangeSigma& range : calibrated.range_sigmas) {
    text += "  - {laser: \"" + range.laser + "\", distance_m: " + Exactly(range.distance_m) +
            ", sigma_m: " + Exactly(range.sigma_m) + "}\n";
  }
  text +=
      "# Differences from the drawing. weak: told by the drawing more than by the "
      "pictures.\nestimates:\n";
  for (const geometry::RigEstimate& estimate : calibrated.estimates) {
    text += "  - {part: \"" + estimate.part + "\", what: \"" + estimate.what + "\", unit: \"" +
            estimate.unit + "\", difference: " + Exactly(estimate.difference) +
            ", sigma: " + Exactly(estimate.sigma) +
            ", weak: " + (estimate.weak ? "true" : "false") + "}\n";
  }
  return text + std::string(kRigHashKey) + "\"" + ContentHash(text) + "\"\n";
}

Result<CalibratedRig> ParseCalibratedRig(const std::string& text, const std::string& name,
                                         const SensorRig& drawn) {
  const Status whole = CheckHash(text, name);
  if (!whole.ok()) return whole;
  const Result<YamlDocument> document = YamlDocument::Parse(text, name);
  if (!document.ok()) return document.status();
  YamlSection root = document->root();
  root.Ignore("fnv1a");
  std::string format;
  root.Read("format", &format);
  root.Check(format == kRigFormat, "format", std::string("must be ") + kRigFormat);
  CalibratedRig calibrated;
  calibrated.rig = drawn;
  ReadPlain(&root, "date", &calibrated.date);
  root.Read("stops", &calibrated.stops);
  root.Read("views", &calibrated.views);

  SensorRig& rig = calibrated.rig;
  YamlSection ptu = root.Child("ptu");
  rig.X_RP = ReadPose(&ptu, "rotation_RP");
  ptu.ReadAngle("tilt_roll_deg", &rig.ptu_axes.tilt_roll_rad);
  ptu.ReadAngle("tilt_yaw_deg", &rig.ptu_axes.tilt_yaw_rad);
  rig.ptu_axes.p_PTilt_m = ReadVector(&ptu, "tilt_axis_m");
  YamlSection color = root.Child("color_camera");
  rig.X_TC = ReadPose(&color, "rotation_TC");
  rig.color_camera = ReadLens(&color);
  YamlSection stripe = root.Child("stripe_camera");
  rig.X_TB = ReadPose(&stripe, "rotation_TB");
  rig.stripe_camera = ReadLens(&stripe);
  rig.horizontal_laser = ReadFan(root.Child("horizontal_laser"));
  rig.vertical_laser = ReadFan(root.Child("vertical_laser"));
  ReadQuality(&root, &calibrated);
  const Status status = document->Finish();
  if (!status.ok()) return status;
  return calibrated;
}

Status CheckAgainstDrawing(const SensorRig& calibrated, const SensorRig& drawn) {
  constexpr double kPosition_m = 0.02;
  constexpr double kTurn_rad = RadiansFromDegrees(3.0);
  constexpr double kFocal_1 = 0.10;
  std::string wrong;
  const auto check = [&wrong](double off, double limit, const std::string& what, const char* unit) {
    if (off <= limit || !wrong.empty()) return;
    wrong = what + " is " + Exactly(std::round(100.0 * off) / 100.0) + " " + unit +
            " from where it is drawn, at most " + Exactly(limit) + " " + unit + " are believed";
  };
  const auto check_pose = [&](const std::string& part, const RigidTransform& X,
                              const RigidTransform& as_drawn) {
    check(1000.0 * (X.translation() - as_drawn.translation()).norm(), 1000.0 * kPosition_m, part,
          "mm");
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(X.linear().transpose() * as_drawn.linear()));
    check(DegreesFromRadians(turn.angle()), DegreesFromRadians(kTurn_rad), part, "degrees");
  };
  const auto check_lens = [&](const std::string& part, const PinholeCamera& camera,
                              const PinholeCamera& as_drawn) {
    if (camera.width_px != as_drawn.width_px || camera.height_px != as_drawn.height_px) {
      wrong = part + " was calibrated with pictures of " + std::to_string(camera.width_px) + " x " +
              std::to_string(camera.height_px) + ", drawn are " +
              std::to_string(as_drawn.width_px) + " x " + std::to_string(as_drawn.height_px);
    }
    check(100.0 * std::abs(camera.fx_px / as_drawn.fx_px - 1.0), 100.0 * kFocal_1,
          part + "'s focal length", "%");
  };
  const auto check_fan = [&](const std::string& part, const LaserMount& laser,
                             const LaserMount& as_drawn) {
    check(1000.0 * std::abs(as_drawn.normal_T.dot(laser.p_TLaser_m - as_drawn.p_TLaser_m)),
          1000.0 * kPosition_m, part, "mm");
    check(DegreesFromRadians(std::acos(std::min(1.0, laser.normal_T.dot(as_drawn.normal_T)))),
          DegreesFromRadians(kTurn_rad), part, "degrees");
  };
  check_lens("the colour camera", calibrated.color_camera, drawn.color_camera);
  check_lens("the B/W camera", calibrated.stripe_camera, drawn.stripe_camera);
  check_pose("the pan-tilt unit", calibrated.X_RP, drawn.X_RP);
  check_pose("the colour camera", calibrated.X_TC, drawn.X_TC);
  check_pose("the B/W camera", calibrated.X_TB, drawn.X_TB);
  check_fan("the horizontal laser", calibrated.horizontal_laser, drawn.horizontal_laser);
  check_fan("the vertical laser", calibrated.vertical_laser, drawn.vertical_laser);
  check(1000.0 * calibrated.ptu_axes.p_PTilt_m.norm(), 1000.0 * kPosition_m, "the tilt axis", "mm");
  check(DegreesFromRadians(
            std::hypot(calibrated.ptu_axes.tilt_roll_rad, calibrated.ptu_axes.tilt_yaw_rad)),
        DegreesFromRadians(kTurn_rad), "the tilt axis", "degrees");
  if (wrong.empty()) return Status::Ok();
  return Status::Error(wrong + ": calibrated with another robot, or drawn wrongly?");
}

}  // namespace geon::config
