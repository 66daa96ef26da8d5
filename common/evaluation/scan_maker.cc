#include "evaluation/scan_maker.h"

#include <Eigen/Geometry>
#include <algorithm>
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
constexpr double kRayStart_m = 0.6;     // rays start so far before the object's middle
constexpr double kAirBelow_m = 0.5;     // an object in the air has so much below it
constexpr double kFarthest_m = 3.0;     // floor points are measured so far behind the object
constexpr double kPivotReach_m = 0.15;  // a robot leans about a point so near below its camera
constexpr int kTagSamples = 3;          // a colour tag is the mean over so many places each way ...
constexpr double kTagStep_px = 3.0;     // ... so far apart
constexpr double kColorError_px = 1.0;  // of the colour camera's calibration
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
  if (view.floor) camera.floor_z_O_m = view.floor_m;
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

// What the fan's rays reach and the camera sees, for each line of the image.
struct TrueStripe {
  std::vector<double> depths_m;  // z in B, else infinity
  std::vector<bool> on_object;
};

TrueStripe FindTrueStripe(const ObjectTracer& object, const Camera& camera, const Fan& fan,
                          std::span<const double> tangents) {
  const double start_m = std::max(0.0, camera.range_m - kRayStart_m);
  std::vector<ObjectRay> rays;
  for (double along_1 : tangents) {
    const Eigen::Vector3d direction_B = fan.Ray(along_1);
    rays.push_back({camera.X_OB * (fan.LaserInB() + start_m * direction_B),
                    camera.X_OB.linear() * direction_B});
  }
  TrueStripe stripe;
  stripe.depths_m = object.FirstHits(rays, &stripe.on_object);
  std::vector<ObjectRay> sights;
  for (size_t i = 0; i < rays.size(); ++i) {
    const double floor_m = (camera.floor_z_O_m - rays[i].origin_m.z()) / rays[i].direction.z();
    double& z_m = stripe.depths_m[i];
    if (rays[i].direction.z() < 0.0 && floor_m < z_m) {
      z_m = floor_m;
      stripe.on_object[i] = false;
    }
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
      if (hidden[i]) stripe.depths_m[i] = kInfinity;
    }
  }
  return stripe;
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

// Where a robot believes its camera that leans, about a point of the floor near below the camera.
RigidTransform BelievedUpright(const RigidTransform& X_LB, double lean_rad, double floor_m,
                               std::mt19937_64& random) {
  const double direction_rad = Uniform(random, 0.0, 2.0 * kPi);
  const double pivot_x_m = Uniform(random, -kPivotReach_m, kPivotReach_m);
  const double pivot_y_m = Uniform(random, -kPivotReach_m, kPivotReach_m);
  const Eigen::Vector3d pivot_m(pivot_x_m, pivot_y_m, floor_m);
  const Eigen::AngleAxisd turn(
      lean_rad, Eigen::Vector3d(std::cos(direction_rad), std::sin(direction_rad), 0));
  const RigidTransform X_LB_believed =
      Eigen::Translation3d(pivot_m) * turn * Eigen::Translation3d(-pivot_m) * X_LB;
  const Eigen::Vector3d foot_m(X_LB_believed.translation().x(), X_LB_believed.translation().y(), 0);
  return Eigen::Translation3d(-foot_m) * X_LB_believed;
}

RigidTransform Believed(const RigidTransform& X_LB, const FaultOptions& faults, double floor_m,
                        std::mt19937_64& random) {
  if (faults.lean_rad != 0.0) return BelievedUpright(X_LB, faults.lean_rad, floor_m, random);
  if (faults.attitude_rad == 0.0) return X_LB;
  std::normal_distribution<double> gauss;
  const Eigen::AngleAxisd turn(faults.attitude_rad, NormalVector(random, gauss).normalized());
  return geometry::MakeTransform(X_LB.linear() * turn.toRotationMatrix(), X_LB.translation());
}

// The colour camera: how it sees the target's surface, wrongly by `error_px` all over the picture.
struct ColorCamera {
  const ObjectTracer& object;
  const Camera& camera;
  double above_m = 0.0;
  Eigen::Vector2d error_px = Eigen::Vector2d::Zero();

  // Which of these places of its picture, in pixels from its axis, show the target.
  std::vector<bool> ShowTarget(std::span<const Eigen::Vector2d> places_px) const {
    const Eigen::Vector3d eye_O = camera.X_OB * Eigen::Vector3d(0.0, -above_m, 0.0);
    std::vector<ObjectRay> rays;
    for (const Eigen::Vector2d& place_px : places_px) {
      const Eigen::Vector3d direction_B = (place_px / camera.focal_px).homogeneous();
      rays.push_back({eye_O, camera.X_OB.linear() * direction_B});
    }
    std::vector<bool> on_object;
    object.FirstHits(rays, &on_object);
    return on_object;
  }
};

// The tags of one profile's points, frame B.
std::vector<double> ColorTags(const ColorCamera& color, std::span<const Eigen::Vector3d> p_B_m) {
  std::vector<Eigen::Vector2d> places_px;
  for (const Eigen::Vector3d& p_B : p_B_m) {
    const Eigen::Vector2d p_C(p_B.x(), p_B.y() + color.above_m);
    const Eigen::Vector2d place_px = color.camera.focal_px / p_B.z() * p_C + color.error_px;
    for (int k = 0; k < kTagSamples * kTagSamples; ++k) {
      const Eigen::Vector2d step(k % kTagSamples - kTagSamples / 2,
                                 k / kTagSamples - kTagSamples / 2);
      places_px.push_back(place_px + kTagStep_px * step);
    }
  }
  const std::vector<bool> shows = color.ShowTarget(places_px);
  std::vector<double> tags;
  const size_t samples = kTagSamples * kTagSamples;
  for (size_t i = 0; i < p_B_m.size(); ++i) {
    const auto begin = shows.begin() + static_cast<std::ptrdiff_t>(i * samples);
    const auto count = std::count(begin, begin + static_cast<std::ptrdiff_t>(samples), true);
    tags.push_back(static_cast<double>(count) / static_cast<double>(samples));
  }
  return tags;
}

}  // namespace

sensor::ScanSet MakeScan(const ObjectTracer& object, const ViewOptions& view,
                         const FaultOptions& faults, const RangefinderOptions& rangefinder,
                         std::mt19937_64& random) {
  return MakeLabelledScan(object, view, faults, rangefinder, random).scan;
}

LabelledScan MakeLabelledScan(const ObjectTracer& object, const ViewOptions& view,
                              const FaultOptions& faults, const RangefinderOptions& rangefinder,
                              std::mt19937_64& random) {
  const Camera camera = PlaceCamera(object, view, rangefinder);
  const Eigen::AlignedBox2d box = TargetBox(object, camera, rangefinder);
  const RigidTransform X_LB = Believed(camera.X_LB, faults, view.floor_m, random);
  const double centre_u_px = 0.5 * (rangefinder.width_px - 1);
  const double centre_v_px = 0.5 * (rangefinder.height_px - 1);

  LabelledScan labelled;
  sensor::ScanSet& scan = labelled.scan;
  scan.camera_position_L_m = X_LB.translation();
  scan.rotation_LB = X_LB.linear();
  const Eigen::Vector2d corner_px = box.min() + Eigen::Vector2d(centre_u_px, centre_v_px);
  scan.target_box = sensor::PixelBox{static_cast<int>(std::floor(corner_px.x())),
                                     static_cast<int>(std::floor(corner_px.y())),
                                     static_cast<int>(std::ceil(box.sizes().x())) + 1,
                                     static_cast<int>(std::ceil(box.sizes().y())) + 1};
  const OffsetError offset_error(faults, random);
  std::normal_distribution<double> gauss;
  ColorCamera color{object, camera, rangefinder.color_above_m};
  if (rangefinder.color_tags) {
    color.error_px = kColorError_px * NormalVector(random, gauss).head<2>();
  }
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
    const TrueStripe stripe = FindTrueStripe(object, camera, fan, tangents);
    const std::vector<double> depths_m = MatchPatches(stripe.depths_m, faults, random);
    std::vector<Eigen::Vector3d> p_B_m;
    std::vector<bool>& on_object = labelled.on_object.emplace_back();
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
      on_object.push_back(stripe.on_object[i]);
      p_B_m.push_back(p_B);
    }
    if (rangefinder.color_tags) profile.on_color_1 = ColorTags(color, p_B_m);
    scan.profiles.push_back(std::move(profile));
  }
  return labelled;
}

}  // namespace geon::evaluation
