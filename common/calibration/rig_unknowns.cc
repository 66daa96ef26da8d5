#include "calibration/rig_unknowns.h"

#include "base/angles.h"

namespace geon::calibration {
namespace {

using geometry::LaserMount;
using geometry::PinholeCamera;
using geometry::RigidTransform;

constexpr double kDegrees = 180.0 / kPi;
constexpr double kMillimetres = 1000.0;

void AddCamera(const std::string& part, std::vector<UnknownName>* names) {
  for (const UnknownName& name : std::initializer_list<UnknownName>{
           {part, "focal length", "px", 1.0},
           {part, "height to width of a pixel", "%", 100.0},
           {part, "centre u", "px", 1.0},
           {part, "centre v", "px", 1.0},
           {part, "distortion k1", "", 1.0},
           {part, "distortion k2", "", 1.0},
           {part, "turned about its x (pitch)", "deg", kDegrees},
           {part, "turned about its y (yaw)", "deg", kDegrees},
           {part, "turned about its axis (roll)", "deg", kDegrees},
           {part, "position x", "mm", kMillimetres},
           {part, "position y", "mm", kMillimetres},
           {part, "position z", "mm", kMillimetres},
       }) {
    names->push_back(name);
  }
}

void AddLaser(const std::string& part, std::vector<UnknownName>* names) {
  names->push_back({part, "turned about its beam", "deg", kDegrees});
  names->push_back({part, "turned about its stripe", "deg", kDegrees});
  names->push_back({part, "shifted across its plane", "mm", kMillimetres});
}

void MoveCamera(const double* lens, const double* mount, PinholeCamera* camera,
                RigidTransform* X_TC) {
  camera->fx_px += lens[0];
  camera->fy_px = (camera->fy_px + lens[0]) * (1.0 + lens[1]);
  camera->cx_px += lens[2];
  camera->cy_px += lens[3];
  camera->k1_1 += lens[4];
  camera->k2_1 += lens[5];
  const Eigen::Vector3d turn_rad(mount[0], mount[1], mount[2]);
  if (turn_rad.norm() > 0.0) {
    X_TC->linear() = X_TC->linear() *
                     Eigen::AngleAxisd(turn_rad.norm(), turn_rad.normalized()).toRotationMatrix();
  }
  X_TC->translation() += Eigen::Vector3d(mount[3], mount[4], mount[5]);
}

void MoveLaser(const double* unknowns, LaserMount* laser) {
  const LaserAxes axes = AxesOf(*laser);
  const Eigen::Vector3d normal_T = laser->normal_T;
  laser->p_TLaser_m += unknowns[2] * normal_T;
  laser->normal_T = (normal_T + unknowns[0] * axes.beam_T.cross(normal_T) +
                     unknowns[1] * axes.stripe_T.cross(normal_T))
                        .normalized();
}

}  // namespace

Status DrawingTolerances::Validate() const {
  for (const double sigma :
       {focal_1, aspect_1, center_px, k1_1, k2_1, turn_rad, position_m, axis_rad, axis_m}) {
    if (!(sigma > 0.0)) return Status::Error("every tolerance must be positive");
  }
  return Status::Ok();
}

const std::array<UnknownName, RigUnknowns::kAll>& UnknownNames() {
  static const auto kNames = [] {
    std::vector<UnknownName> names;
    AddCamera("B/W camera", &names);
    AddCamera("colour camera", &names);
    names.push_back({"pan-tilt unit", "roll of the tilt axis", "deg", kDegrees});
    names.push_back({"pan-tilt unit", "tilt axis ahead of the pan axis", "mm", kMillimetres});
    AddLaser("horizontal laser", &names);
    AddLaser("vertical laser", &names);
    std::array<UnknownName, RigUnknowns::kAll> all;
    std::move(names.begin(), names.end(), all.begin());
    return all;
  }();
  return kNames;
}

std::array<double, RigUnknowns::kAll> PriorSigmas(const DrawingTolerances& tolerances,
                                                  const geometry::SensorRig& drawn) {
  const DrawingTolerances& t = tolerances;
  std::array<double, RigUnknowns::kAll> sigmas{};
  auto next = sigmas.begin();
  for (const PinholeCamera* camera : {&drawn.stripe_camera, &drawn.color_camera}) {
    for (const double sigma :
         {t.focal_1 * camera->fx_px, t.aspect_1, t.center_px, t.center_px, t.k1_1, t.k2_1,
          t.turn_rad, t.turn_rad, t.turn_rad, t.position_m, t.position_m, t.position_m}) {
      *next++ = sigma;
    }
  }
  for (const double sigma : {t.axis_rad, t.axis_m, t.turn_rad, t.turn_rad, t.position_m, t.turn_rad,
                             t.turn_rad, t.position_m}) {
    *next++ = sigma;
  }
  return sigmas;
}

geometry::SensorRig RigFrom(const RigUnknowns& unknowns, const geometry::SensorRig& drawn) {
  geometry::SensorRig rig = drawn;
  MoveCamera(unknowns[RigUnknowns::kStripeLens], unknowns[RigUnknowns::kStripeMount],
             &rig.stripe_camera, &rig.X_TB);
  MoveCamera(unknowns[RigUnknowns::kColorLens], unknowns[RigUnknowns::kColorMount],
             &rig.color_camera, &rig.X_TC);
  const double* axes = unknowns[RigUnknowns::kAxes];
  rig.ptu_axes = {axes[0], 0.0, {axes[1], 0.0, 0.0}};
  MoveLaser(unknowns[RigUnknowns::kHorizontal], &rig.horizontal_laser);
  MoveLaser(unknowns[RigUnknowns::kVertical], &rig.vertical_laser);
  return rig;
}

LaserAxes AxesOf(const LaserMount& laser) {
  LaserAxes axes;
  const Eigen::Vector3d forward_T = Eigen::Vector3d::UnitX();
  axes.beam_T = (forward_T - laser.normal_T.dot(forward_T) * laser.normal_T).normalized();
  axes.stripe_T = laser.normal_T.cross(axes.beam_T);
  return axes;
}

}  // namespace geon::calibration
