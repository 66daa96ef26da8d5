#include "evaluation/scan_maker.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "base/angles.h"
#include "base/contracts.h"
#include "evaluation/stripe_noise.h"
#include "evaluation/trial_random.h"
#include "geometry/rigid_transform.h"

namespace geon::evaluation {
namespace {

using geometry::RigidTransform;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kOrthographicRange_m = 100.0;
constexpr double kRayStart_m = 0.6;      // rays start so far before the object's middle
constexpr double kAirBelow_m = 0.5;      // an object in the air has so much below it
constexpr double kFarthest_m = 3.0;      // floor points are measured so far behind the object
constexpr double kShadowEnd_1 = 0.9995;  // shadow rays end this far, short of their surface

// Everything about one view that its six stripes share. Frame B is the B/W camera.
struct Camera {
  double range_m = 1.0;  // to the object's middle
  double focal_px = 1600.0;
  RigidTransform X_LB;
  RigidTransform X_OB;  // object
  double floor_z_O_m = -kInfinity;
};

Camera PlaceCamera(const ObjectTracer& object, const ViewOptions& view,
                   const RangefinderOptions& rangefinder) {
  Require(view.range_m > 0.0, "range_m must be positive");
  Camera camera;
  camera.range_m = view.orthographic ? kOrthographicRange_m : view.range_m;
  camera.focal_px = rangefinder.focal_px * camera.range_m / view.range_m;
  const double lift_m = view.floor ? 0.0 : kAirBelow_m;
  const double c = std::cos(view.elevation_rad), s = std::sin(view.elevation_rad);
  const double middle_m = 0.5 * object.height_m() + lift_m;
  camera.X_LB = geometry::MakeTransform(
      geometry::RotationAboutY(view.elevation_rad) * geometry::CameraAxesInBody(),
      Eigen::Vector3d(0.0, 0.0, middle_m + camera.range_m * s));
  const RigidTransform X_LO =
      geometry::MakeTransform(geometry::RotationAboutZ(kPi - view.azimuth_rad),
                              Eigen::Vector3d(camera.range_m * c, 0.0, lift_m));
  camera.X_OB = X_LO.inverse() * camera.X_LB;
  if (view.floor) camera.floor_z_O_m = 0.0;
  return camera;
}

// The target's bounds in the colour camera, in pixels from its optical axis.
Eigen::AlignedBox2d TargetBox(const ObjectTracer& object, const Camera& camera,
                              const RangefinderOptions& rangefinder) {
  const RigidTransform X_BO = camera.X_OB.inverse();
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& p_O : object.outline_m()) {
    const Eigen::Vector3d p_B = X_BO * p_O;
    const Eigen::Vector2d p_C(p_B.x(), p_B.y() + rangefinder.color_above_m);
    box.extend(Eigen::Vector2d(p_C * (camera.focal_px / p_B.z())));
  }
  return box;
}

// The fan of one stripe. `across` is the image axis that the stripe's place is measured along: 1
// (rows) for a horizontal stripe, 0 (columns) for a vertical one.
struct Fan {
  int across = 1;
  double baseline_m = 0.0;  // the laser stands at -baseline on the axis `across` of B
  double slope_1 = 0.0;     // of the fan: across = -baseline + slope * z

  Eigen::Vector3d LaserInB() const {
    Eigen::Vector3d p_B = Eigen::Vector3d::Zero();
    p_B[across] = -baseline_m;
    return p_B;
  }
  // Of the fan's ray that the camera sees in the line (column or row) of tangent `along_1`.
  Eigen::Vector3d Ray(double along_1) const {
    Eigen::Vector3d direction_B(0.0, 0.0, 1.0);
    direction_B[across] = slope_1;
    direction_B[1 - across] = along_1;
    return direction_B;
  }
};

Fan LayStripe(bool vertical, double fraction, const Eigen::AlignedBox2d& box, const Camera& camera,
              const ViewOptions& view, const RangefinderOptions& rangefinder) {
  Fan fan;
  fan.across = vertical ? 0 : 1;
  fan.baseline_m = view.orthographic || rangefinder.depth_camera ? 0.0 : rangefinder.baseline_m;
  const double place_px = box.min()[fan.across] + fraction * box.sizes()[fan.across];
  double place_m = camera.range_m * place_px / camera.focal_px;
  if (!vertical) place_m -= rangefinder.color_above_m;  // from the colour camera to B
  fan.slope_1 = (place_m + fan.baseline_m) / camera.range_m;
  return fan;
}

// What the fan's rays reach and the camera sees: z in B for each line of the image, else infinity.
std::vector<double> TrueDepths(const ObjectTracer& object, const Camera& camera, const Fan& fan,
                               std::span<const double> tangents) {
  const double start_m = std::max(0.0, camera.range_m - kRayStart_m);
  std::vector<ObjectRay> rays;
  for (double along_1 : tangents) {
    const Eigen::Vector3d direction_B = fan.Ray(along_1);
    rays.push_back({camera.X_OB * (fan.LaserInB() + start_m * direction_B),
                    camera.X_OB.linear() * direction_B});
  }
  std::vector<double> depths_m = object.FirstHits(rays);
  std::vector<ObjectRay> sights;
  for (size_t i = 0; i < rays.size(); ++i) {
    const double floor_m = (camera.floor_z_O_m - rays[i].origin_m.z()) / rays[i].direction.z();
    double& z_m = depths_m[i];
    if (rays[i].direction.z() < 0.0 && floor_m < z_m) z_m = floor_m;
    z_m += start_m;
    const bool lit = z_m < camera.range_m + kFarthest_m;
    const Eigen::Vector3d p_O = rays[i].origin_m + (z_m - start_m) * rays[i].direction;
    if (!lit) z_m = kInfinity;
    const Eigen::Vector3d eye_O = camera.X_OB.translation();
    const Eigen::Vector3d from_O = eye_O + (start_m / camera.range_m) * (p_O - eye_O);
    sights.push_back(lit ? ObjectRay{from_O, p_O - from_O, kShadowEnd_1}
                         : ObjectRay{rays[i].origin_m, rays[i].direction, 0.0});
  }
  if (fan.baseline_m > 0.0) {
    const std::vector<bool> hidden = object.Hits(sights);
    for (size_t i = 0; i < hidden.size(); ++i) {
      if (hidden[i]) depths_m[i] = kInfinity;
    }
  }
  return depths_m;
}

// Depth by triangulation of a stripe that stands `error_px` off its true place.
double MeasuredDepth(double z_m, double error_px, const Camera& camera, const Fan& fan,
                     const ViewOptions& view, const RangefinderOptions& rangefinder,
                     double step_px) {
  const double scale_mpx = rangefinder.baseline_m * rangefinder.focal_px;
  if (view.orthographic) {  // the same error of depth, but nowhere else
    return z_m + view.range_m * view.range_m / scale_mpx * error_px;
  }
  if (rangefinder.depth_camera) {
    const double offset_px = scale_mpx / z_m - error_px;
    const double read_px =
        step_px > 0.0 ? step_px * std::max(std::round(offset_px / step_px), 1.0) : offset_px;
    return scale_mpx / read_px;
  }
  const double tangent = fan.slope_1 - fan.baseline_m / z_m + error_px / camera.focal_px;
  return fan.baseline_m / (fan.slope_1 - tangent);
}

RigidTransform Believed(const RigidTransform& X_LB, double attitude_rad, std::mt19937_64& random) {
  if (attitude_rad == 0.0) return X_LB;
  std::normal_distribution<double> gauss;
  const Eigen::AngleAxisd turn(attitude_rad, NormalVector(random, gauss).normalized());
  return geometry::MakeTransform(X_LB.linear() * turn.toRotationMatrix(), X_LB.translation());
}

}  // namespace

sensor::ScanSet MakeScan(const ObjectTracer& object, const ViewOptions& view,
                         const FaultOptions& faults, const RangefinderOptions& rangefinder,
                         std::mt19937_64& random) {
  const Camera camera = PlaceCamera(object, view, rangefinder);
  const Eigen::AlignedBox2d box = TargetBox(object, camera, rangefinder);
  const RigidTransform X_LB = Believed(camera.X_LB, faults.attitude_rad, random);
  const double centre_u_px = 0.5 * (rangefinder.width_px - 1);
  const double centre_v_px = 0.5 * (rangefinder.height_px - 1);

  sensor::ScanSet scan;
  scan.camera_position_L_m = X_LB.translation();
  scan.rotation_LB = X_LB.linear();
  const Eigen::Vector2d corner_px = box.min() + Eigen::Vector2d(centre_u_px, centre_v_px);
  scan.target_box = sensor::PixelBox{static_cast<int>(std::floor(corner_px.x())),
                                     static_cast<int>(std::floor(corner_px.y())),
                                     static_cast<int>(std::ceil(box.sizes().x())) + 1,
                                     static_cast<int>(std::ceil(box.sizes().y())) + 1};
  const OffsetError offset_error(faults, random);
  std::normal_distribution<double> gauss;
  for (int k = 0; k < 6; ++k) {
    const bool vertical = k >= 3;
    sensor::RangeProfile profile;
    profile.stripe_index = k;
    profile.laser = vertical ? sensor::Laser::kVertical : sensor::Laser::kHorizontal;
    profile.fraction = 0.25 * (k % 3 + 1);
    const double place_1 = profile.fraction + faults.misplacement_1 * gauss(random);
    const Fan fan = LayStripe(vertical, place_1, box, camera, view, rangefinder);
    profile.laser_origin_L_m = X_LB * fan.LaserInB();

    const int lines = vertical ? rangefinder.height_px : rangefinder.width_px;
    const double centre_px = vertical ? centre_v_px : centre_u_px;
    std::vector<double> tangents;
    for (int line = 0; line < lines; ++line) {
      tangents.push_back((line - centre_px) / camera.focal_px);
    }
    const std::vector<double> depths_m =
        MatchPatches(TrueDepths(object, camera, fan, tangents), faults, random);
    const std::vector<StripeError> errors = StripeErrors(depths_m.size(), faults, random);
    for (size_t i = 0; i < depths_m.size(); ++i) {
      if (depths_m[i] == kInfinity || errors[i].missing) continue;
      Eigen::Vector2d tangent_1(fan.slope_1, fan.slope_1);
      tangent_1[1 - fan.across] = tangents[i];
      const double error_px = errors[i].offset_px + offset_error.At(tangent_1 * camera.focal_px);
      const double z_m =
          MeasuredDepth(depths_m[i], error_px, camera, fan, view, rangefinder, faults.step_px);
      // The point measured: where the camera's ray through the displaced pixel has this depth.
      const Eigen::Vector3d p_B = fan.LaserInB() + z_m * fan.Ray(tangents[i]);
      const Eigen::Vector3d true_B = fan.LaserInB() + depths_m[i] * fan.Ray(tangents[i]);
      const double height_m = (camera.X_OB * true_B).z();
      if (!(z_m > 0.0) || z_m > camera.range_m + kFarthest_m) continue;
      if (faults.floor_cut_m > 0.0 && height_m < faults.floor_cut_m) continue;
      profile.pixel.push_back(static_cast<int>(i));
      profile.p_L_m.push_back(X_LB * p_B);
    }
    scan.profiles.push_back(std::move(profile));
  }
  return scan;
}

}  // namespace geon::evaluation
