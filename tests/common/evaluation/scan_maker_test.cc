#include "evaluation/scan_maker.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angles.h"
#include "geometry/rigid_transform.h"
#include "geons/polygon_geon.h"

namespace geon::evaluation {
namespace {

ObjectTracer BoxOnFloor() {
  return ObjectTracer(geons::PolygonGeon({GeonLabel::kCuboid, {0.16, 0.16, 0.16}}, 48));
}

ViewOptions FrontView() {
  ViewOptions view;
  view.elevation_rad = RadiansFromDegrees(35);
  view.floor = true;
  return view;
}

sensor::ScanSet Scan(const ViewOptions& view, const FaultOptions& faults, uint64_t seed = 1) {
  std::mt19937_64 random(seed);
  return MakeScan(BoxOnFloor(), view, faults, {}, random);
}

FaultOptions NoFaults() {
  FaultOptions faults;
  faults.noise_px = 0.0;
  return faults;
}

// How far a point lies from the surface of the box, whose front face is at x = `front_m`, and from
// the floor, whichever is nearer.
double Distance(const Eigen::Vector3d& p_m, double front_m) {
  const Eigen::Vector3d half(0.08, 0.08, 0.08);
  const Eigen::Vector3d q = (p_m - Eigen::Vector3d(front_m + 0.08, 0.0, 0.08)).cwiseAbs() - half;
  const double box_m = q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
  return std::min(std::abs(box_m), std::abs(p_m.z()));
}

TEST(MakeScan, PointsWithoutNoiseLieOnTheObjectOrTheFloor) {
  const ViewOptions view = FrontView();
  const double front_m = view.range_m * std::cos(view.elevation_rad) - 0.08;
  const sensor::ScanSet scan = Scan(view, NoFaults());
  ASSERT_EQ(scan.profiles.size(), 6U);
  for (const sensor::RangeProfile& profile : scan.profiles) {
    EXPECT_GT(profile.p_L_m.size(), 200U);
    for (const Eigen::Vector3d& p_m : profile.p_L_m) EXPECT_LT(Distance(p_m, front_m), 1e-5);
  }
}

TEST(MakeScan, StripesLieAtTheQuartersOfTheObject) {
  const sensor::ScanSet scan = Scan(FrontView(), NoFaults());
  for (size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(scan.profiles[k].laser, sensor::Laser::kHorizontal);
    EXPECT_EQ(scan.profiles[k + 3].laser, sensor::Laser::kVertical);
    EXPECT_NEAR(scan.profiles[k + 3].fraction, 0.25 * static_cast<double>(k + 1), 1e-12);
    // Left is +y: a quarter of 0.16 m apart, but for the perspective of the near face.
    double y_m = 0.0;
    for (const Eigen::Vector3d& p_m : scan.profiles[k + 3].p_L_m) {
      if (p_m.z() > 0.02 && p_m.z() < 0.14) y_m = p_m.y();
    }
    EXPECT_NEAR(y_m, 0.04 * (1.0 - static_cast<double>(k)), 0.012);
  }
}

TEST(MakeScan, PixelsRiseAndAgreeWithThePoints) {
  const sensor::ScanSet scan = Scan(FrontView(), {});
  for (const sensor::RangeProfile& profile : scan.profiles) {
    for (size_t i = 0; i < profile.pixel.size(); ++i) {
      if (i > 0) {
        EXPECT_GT(profile.pixel[i], profile.pixel[i - 1]);
      }
      const Eigen::Vector3d p_B =
          scan.rotation_LB.transpose() * (profile.p_L_m[i] - scan.camera_position_L_m);
      const int along = profile.laser == sensor::Laser::kHorizontal ? 0 : 1;
      EXPECT_NEAR(319.5 + 1600.0 * p_B[along] / p_B.z(), profile.pixel[i], 1e-6);
    }
  }
}

// 0.1 px are 1.0 mm at 1.0 m and 2.56 mm at 1.6 m for a baseline of 62.5 mm (section 3.2).
TEST(MakeScan, NoiseOfDepthGrowsWithTheSquareOfTheDistance) {
  for (const double range_m : {1.0, 1.6}) {
    ViewOptions view = FrontView();
    view.range_m = range_m;
    const sensor::ScanSet exact = Scan(view, NoFaults()), noisy = Scan(view, {});
    double sum = 0.0;
    int n = 0;
    for (size_t k = 0; k < 3; ++k) {
      for (size_t i = 0; i < exact.profiles[k].p_L_m.size(); ++i) {
        const auto forward_L = exact.rotation_LB.col(2);
        const double z_m = forward_L.dot(exact.profiles[k].p_L_m[i] - exact.camera_position_L_m);
        const double error_m =
            forward_L.dot(noisy.profiles[k].p_L_m[i] - exact.profiles[k].p_L_m[i]);
        sum += std::pow(error_m / (z_m * z_m), 2);
        ++n;
      }
    }
    EXPECT_NEAR(std::sqrt(sum / n), 0.0010, 0.00006);
  }
}

// An arch that opens upward, seen end-on: its near arm hides part of what the laser, which looks
// over it from higher up, lights inside.
TEST(MakeScan, PointsAreLitAndSeenAndWhatIsHiddenIsAGap) {
  const geons::GeonShape arch{GeonLabel::kBentCuboid, {0.05, 0.10, 0.34}, 0.0, kPi, 3};
  const ObjectTracer object(geons::PolygonGeon(arch, 48));
  ViewOptions view;
  view.elevation_rad = RadiansFromDegrees(55);
  view.floor = true;
  RangefinderOptions rangefinder;
  rangefinder.baseline_m = 0.2;
  std::mt19937_64 random(1);
  const sensor::ScanSet scan = MakeScan(object, view, NoFaults(), rangefinder, random);
  const Eigen::Vector3d foot_L(view.range_m * std::cos(view.elevation_rad), 0.0, 0.0);
  const Eigen::Matrix3d R_OL = geometry::RotationAboutZ(kPi);
  int missing = 0;
  for (const sensor::RangeProfile& profile : scan.profiles) {
    std::vector<ObjectRay> sights;
    for (const Eigen::Vector3d& p_L : profile.p_L_m) {
      for (const Eigen::Vector3d& from_L : {scan.camera_position_L_m, *profile.laser_origin_L_m}) {
        sights.push_back({R_OL * (from_L - foot_L), R_OL * (p_L - from_L), 0.999});
      }
    }
    for (const bool hidden : object.Hits(sights)) EXPECT_FALSE(hidden);
    missing += profile.pixel.back() - profile.pixel.front() + 1;
    missing -= static_cast<int>(profile.pixel.size());
  }
  EXPECT_GT(missing, 20);
}

TEST(MakeScan, InTheAirThereIsNoFloor) {
  ViewOptions view = FrontView();
  view.floor = false;
  for (const sensor::RangeProfile& profile : Scan(view, NoFaults()).profiles) {
    for (const Eigen::Vector3d& p_m : profile.p_L_m) EXPECT_GT(p_m.z(), 0.49);
  }
}

TEST(MakeScan, AnOrthographicViewHasParallelRays) {
  ViewOptions view = FrontView();
  view.orthographic = true;
  view.floor = false;
  const sensor::ScanSet scan = Scan(view, NoFaults());
  for (size_t k = 0; k < 3; ++k) {
    const auto& p_L_m = scan.profiles[k].p_L_m;
    // The same width on the top as on the front, and stripe heights as in the image at 1 m.
    EXPECT_NEAR((p_L_m.back() - p_L_m.front()).norm(), 0.16, 0.001);
  }
}

TEST(MakeScan, FaultsTakePointsAway) {
  const size_t all = Scan(FrontView(), NoFaults()).profiles[1].pixel.size();
  FaultOptions faults;
  faults.dropout_1 = 0.5;
  const size_t half = Scan(FrontView(), faults).profiles[1].pixel.size();
  EXPECT_NEAR(static_cast<double>(half) / static_cast<double>(all), 0.5, 0.12);
  faults = {};
  faults.floor_cut_m = 0.015;
  for (const sensor::RangeProfile& profile : Scan(FrontView(), faults).profiles) {
    for (const Eigen::Vector3d& p_m : profile.p_L_m) EXPECT_GT(p_m.z(), 0.010);
  }
}

TEST(MakeScan, AWrongAttitudeTurnsThePointsAboutTheCamera) {
  FaultOptions faults = NoFaults();
  faults.attitude_rad = RadiansFromDegrees(1.5);
  const sensor::ScanSet scan = Scan(FrontView(), faults), right = Scan(FrontView(), NoFaults());
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(scan.rotation_LB * right.rotation_LB.transpose()));
  EXPECT_NEAR(turn.angle(), RadiansFromDegrees(1.5), 1e-9);
}

TEST(MakeScan, SameRandomStateSameScan) {
  const sensor::ScanSet a = Scan(FrontView(), {}, 7), b = Scan(FrontView(), {}, 7),
                        c = Scan(FrontView(), {}, 8);
  EXPECT_EQ(a.profiles[2].p_L_m, b.profiles[2].p_L_m);
  EXPECT_NE(a.profiles[2].p_L_m, c.profiles[2].p_L_m);
}

TEST(MakeScan, OfADepthCameraHidesNothingAndKeepsItsSteps) {
  RangefinderOptions camera;
  camera.depth_camera = true;
  const double scale_mpx = camera.baseline_m * camera.focal_px;
  FaultOptions faults = NoFaults();
  faults.step_px = 0.25;
  const ViewOptions view = FrontView();
  std::mt19937_64 random(1);
  const sensor::ScanSet scan = MakeScan(BoxOnFloor(), view, faults, camera, random);
  const Eigen::Vector3d eye_m = scan.camera_position_L_m;
  for (const sensor::RangeProfile& profile : scan.profiles) {
    EXPECT_EQ(profile.laser_origin_L_m, eye_m);
    const size_t lines = static_cast<size_t>(profile.pixel.back() - profile.pixel.front()) + 1;
    EXPECT_EQ(profile.pixel.size(), lines) << "object or floor in every line";
    for (const Eigen::Vector3d& p_m : profile.p_L_m) {
      const double steps = scale_mpx / scan.rotation_LB.col(2).dot(p_m - eye_m) / faults.step_px;
      EXPECT_NEAR(steps, std::round(steps), 1e-6);
    }
  }
}

TEST(MakeScan, FindsWhatStandsBesideButDoesNotAimAtIt) {
  const geons::TriangleMesh box = geons::PolygonGeon({GeonLabel::kCuboid, {0.16, 0.16, 0.16}}, 48);
  geons::TriangleMesh beside = box;
  geons::Transform(geometry::MakeTransform(Eigen::Matrix3d::Identity(), {0.0, 0.2, 0.0}), &beside);
  std::mt19937_64 a(1), b(1);
  const auto alone = MakeScan(ObjectTracer(box), FrontView(), NoFaults(), {}, a);
  const auto two = MakeScan(ObjectTracer(box, &beside), FrontView(), NoFaults(), {}, b);
  EXPECT_EQ(two.target_box->u_px, alone.target_box->u_px);
  EXPECT_EQ(two.target_box->w_px, alone.target_box->w_px);
  const auto high = [](const sensor::ScanSet& scan) {
    return std::count_if(scan.profiles[1].p_L_m.begin(), scan.profiles[1].p_L_m.end(),
                         [](const Eigen::Vector3d& p_m) { return p_m.z() > 0.02; });
  };
  EXPECT_GT(high(two), high(alone) + 50);
}

}  // namespace
}  // namespace geon::evaluation
