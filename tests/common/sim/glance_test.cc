#include "sim/glance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/geon_label.h"
#include "sim/random_pen.h"
#include "tests/common/sim/scene_testing.h"

namespace geon::sim {
namespace {

using Eigen::Vector2d;

// A box that stands square in the world.
WorldObject Box(const Vector2d& middle_m, const Eigen::Vector3d& size_m) {
  WorldObject box;
  box.shape = BoxShape{size_m};
  box.x_m = middle_m.x();
  box.y_m = middle_m.y();
  return box;
}

WorldObject Cylinder(const Vector2d& middle_m) {
  geons::GeonShape shape;
  shape.label = GeonLabel::kCylinder;
  shape.size_m = {0.16, 0.16, 0.22};
  WorldObject geon;
  geon.shape = shape;
  geon.x_m = middle_m.x();
  geon.y_m = middle_m.y();
  return geon;
}

// A pen so large that the floor camera sees no wall, with the robot at its lower side.
class GlancerTest : public testing::Test {
 protected:
  GlancerTest() {
    world_.pen_size_m = {10.0, 10.0};
    exact_.edge_sigma_px = 0.0;
    pose_.X_WR = geometry::PlanarPose(5.0, 2.0, kPi / 2.0);
    pose_.tilt_rad = RadiansFromDegrees(-11.0);  // at a target on the floor, 2.5 m off
  }
  std::shared_ptr<const Scene> scene() const { return *BuildScene(world_, {128, 32}); }
  Glancer Made(const GlanceOptions& options, uint64_t seed = 1) const {
    return {scene(), rig_, options, seed};
  }
  geometry::RigidTransform X_WF() const { return pose_.X_WR * rig_.X_RF; }
  geometry::RigidTransform X_WC() const {
    return pose_.X_WR * rig_.ColorCameraPose(pose_.pan_rad, pose_.tilt_rad);
  }
  // Where a pixel of the floor camera looks at the floor.
  Vector2d OnFloor(const Vector2d& pixel_px) const {
    const Eigen::Vector3d ray_W = X_WF().linear() * rig_.floor_camera.Ray(pixel_px);
    const Eigen::Vector3d& eye_m = X_WF().translation();
    return (eye_m - ray_W * (eye_m.z() / ray_W.z())).head<2>();
  }
  Vector2d FloorPixel(const Vector2d& p_W_m) const {
    return rig_.floor_camera.Project(X_WF().inverse() * Eigen::Vector3d(p_W_m.x(), p_W_m.y(), 0.0));
  }
  // The box round all that a geon's mesh projects to: left, right, top, bottom.
  Eigen::Vector4d Projected(const BuiltCamera& camera, const geometry::RigidTransform& X_WCam) {
    Eigen::Vector4d box_px(1e9, -1e9, 1e9, -1e9);
    const auto bodies = scene();
    for (const Body& body : bodies->bodies()) {
      if (!GeonLabelFromString(body.name)) continue;
      for (const Eigen::Vector3d& p_W_m : body.surface_W.vertices_m) {
        const Vector2d pixel_px = camera.Project(X_WCam.inverse() * p_W_m);
        box_px[0] = std::min(box_px[0], pixel_px.x());
        box_px[1] = std::max(box_px[1], pixel_px.x());
        box_px[2] = std::min(box_px[2], pixel_px.y());
        box_px[3] = std::max(box_px[3], pixel_px.y());
      }
    }
    return box_px;
  }
  static void ExpectBox(const GeonGlance& glance, const Eigen::Vector4d& box_px, double within_px) {
    EXPECT_NEAR(glance.left_px, box_px[0], within_px);
    EXPECT_NEAR(glance.right_px, box_px[1], within_px);
    EXPECT_NEAR(glance.top_px, box_px[2], within_px);
    EXPECT_NEAR(glance.bottom_px, box_px[3], within_px);
    EXPECT_NEAR(glance.lowest_px.y(), box_px[3], within_px);
    EXPECT_GT(glance.lowest_px.x(), box_px[0]);
    EXPECT_LT(glance.lowest_px.x(), box_px[1]);
    const double area_px = (box_px[1] - box_px[0]) * (box_px[3] - box_px[2]);
    EXPECT_GT(glance.pixels, 0.5 * area_px);
    EXPECT_LE(glance.pixels, 1.05 * area_px);
  }

  World world_;
  BuiltRig rig_ = AsBuilt(TestRig(), NoMountingErrors());
  GlanceOptions exact_;
  RigPose pose_;
};

TEST_F(GlancerTest, BareFloorHasNoObstacle) {
  const auto glances = Made(exact_).Floor(pose_, 1);
  EXPECT_GT(glances.size(), 40U);
  for (const GroundGlance& glance : glances) {
    EXPECT_FALSE(glance.obstacle);
    EXPECT_TRUE(glance.any_floor);
    // Farther off than it begins, and no farther than is asked for.
    EXPECT_GT((OnFloor(glance.end_px) - OnFloor(glance.begin_px)).norm(), 0.1);
    EXPECT_LT((OnFloor(glance.end_px) - X_WF().translation().head<2>()).norm(),
              exact_.floor_range_m + 0.01);
  }
}

TEST_F(GlancerTest, DirectionsRunFromLeftToRight) {
  const Vector2d below_m = X_WF().translation().head<2>();
  double last_rad = kPi;
  for (const GroundGlance& glance : Made(exact_).Floor(pose_, 1)) {
    const Vector2d along_m = OnFloor(glance.begin_px) - below_m;
    const double bearing_rad = std::atan2(along_m.y(), along_m.x()) - kPi / 2.0;
    EXPECT_LT(bearing_rad, last_rad);
    last_rad = bearing_rad;
  }
}

TEST_F(GlancerTest, ABoxIsToldWhereItsFootProjects) {
  // Its front, 1.2 m before the robot's axis, is all of it that stands in the camera's way.
  const double front_m = 3.2, half_m = 0.3;
  world_.objects.push_back(Box({5.0, front_m + 0.01}, {2.0 * half_m, 0.02, 0.4}));
  const Vector2d below_m = X_WF().translation().head<2>();
  int boxes = 0, free = 0;
  for (const GroundGlance& glance : Made(exact_).Floor(pose_, 1)) {
    const Vector2d along_m = OnFloor(glance.begin_px) - below_m;
    const Vector2d foot_m = below_m + along_m * ((front_m - below_m.y()) / along_m.y());
    if (std::abs(foot_m.x() - 5.0) < half_m - 0.005) {
      ++boxes;
      EXPECT_TRUE(glance.obstacle);
      EXPECT_LT((glance.end_px - FloorPixel(foot_m)).norm(), 2.0);
    } else if (std::abs(foot_m.x() - 5.0) > half_m + 0.02 || along_m.y() < 0.0) {
      ++free;
      EXPECT_FALSE(glance.obstacle);
    }
  }
  EXPECT_GT(boxes, 10);
  EXPECT_GT(free, 10);
}

TEST_F(GlancerTest, ARobotThatTiltsImperceptiblySeesTheSameFloor) {
  // Only of a level robot is it known without rays how far the floor is open.
  const auto tilted = geometry::MakeTransform(
      Eigen::AngleAxisd(1e-6, Eigen::Vector3d::UnitX()).toRotationMatrix(), {0, 0, 0});
  int edges = 0;
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    world_ = RandomPen(seed, MixedPenKind(seed));
    pose_.X_WR =
        geometry::PlanarPose(world_.robot_x_m, world_.robot_y_m, 0.5 * static_cast<double>(seed));
    Glancer glancer = Made(exact_);
    const auto level = glancer.Floor(pose_, 1);
    pose_.X_WR = pose_.X_WR * tilted;
    const auto asked = glancer.Floor(pose_, 1);
    ASSERT_EQ(level.size(), asked.size());
    for (size_t k = 0; k < level.size(); ++k) {
      EXPECT_EQ(level[k].obstacle, asked[k].obstacle) << seed << ' ' << k;
      EXPECT_EQ(level[k].any_floor, asked[k].any_floor);
      EXPECT_LT((level[k].end_px - asked[k].end_px).norm(), 1.0);
      if (level[k].any_floor && level[k].obstacle) ++edges;
    }
  }
  EXPECT_GT(edges, 300);
}

TEST_F(GlancerTest, WhatFillsThePictureLeavesNoFloor) {
  world_.objects.push_back(Box({5.0, 3.2}, {4.0, 2.0, 0.4}));  // up to the robot's very body
  for (const GroundGlance& glance : Made(exact_).Floor(pose_, 1)) {
    const Vector2d begin_m = OnFloor(glance.begin_px);
    if (begin_m.y() < 2.3 || std::abs(begin_m.x() - 5.0) > 1.9) continue;
    EXPECT_TRUE(glance.obstacle);
    EXPECT_FALSE(glance.any_floor);
    EXPECT_EQ(glance.begin_px, glance.end_px);
  }
}

TEST_F(GlancerTest, AGeonIsToldWhereItsMeshProjects) {
  world_.objects.push_back(Cylinder({5.0, 4.5}));
  const auto by_head = Made(exact_).GeonByHead(pose_, 1);
  ASSERT_TRUE(by_head.has_value());
  ExpectBox(*by_head, Projected(rig_.color_camera, X_WC()), 4.0);
  const auto by_floor = Made(exact_).GeonByFloorCamera(pose_, 1);
  ASSERT_TRUE(by_floor.has_value());
  ExpectBox(*by_floor, Projected(rig_.floor_camera, X_WF()), 2.0);
}

TEST_F(GlancerTest, NoiseNeverTurnsABoxInsideOut) {
  world_.objects.push_back(Cylinder({5.0, 9.0}));  // seven metres off: few pixels wide
  GlanceOptions noisy;
  noisy.edge_sigma_px = 20.0;
  int told = 0;
  for (uint64_t seed = 1; seed <= 200; ++seed) {
    const auto glance = Made(noisy, seed).GeonByFloorCamera(pose_, 1);
    if (!glance) continue;
    ++told;
    EXPECT_LE(glance->left_px, glance->right_px);
    EXPECT_LE(glance->top_px, glance->bottom_px);
  }
  EXPECT_GT(told, 0);
  EXPECT_LT(told, 200) << "else the noise was too small to try anything";
}

TEST_F(GlancerTest, TheHeadMustLookThere) {
  world_.objects.push_back(Cylinder({5.0, 4.5}));
  pose_.pan_rad = 0.5;
  EXPECT_FALSE(Made(exact_).GeonByHead(pose_, 1).has_value());
  EXPECT_TRUE(Made(exact_).GeonByFloorCamera(pose_, 1).has_value());
}

TEST_F(GlancerTest, AGeonBehindABoxIsNotTold) {
  world_.objects.push_back(Cylinder({5.0, 4.5}));
  world_.objects.push_back(Box({5.0, 3.8}, {0.8, 0.3, 1.1}));
  EXPECT_FALSE(Made(exact_).GeonByHead(pose_, 1).has_value());
  EXPECT_FALSE(Made(exact_).GeonByFloorCamera(pose_, 1).has_value());
}

TEST_F(GlancerTest, AGeonBehindTheRobotIsNotTold) {
  world_.objects.push_back(Cylinder({5.0, 4.5}));
  pose_.X_WR = geometry::PlanarPose(5.0, 7.0, kPi / 2.0);
  EXPECT_FALSE(Made(exact_).GeonByHead(pose_, 1).has_value());
  EXPECT_FALSE(Made(exact_).GeonByFloorCamera(pose_, 1).has_value());
}

TEST_F(GlancerTest, ABoxIsNoGeon) {
  world_.objects.push_back(Box({5.0, 4.5}, {0.3, 0.3, 0.3}));
  EXPECT_FALSE(Made(exact_).GeonByHead(pose_, 1).has_value());
  EXPECT_FALSE(Made(exact_).GeonByFloorCamera(pose_, 1).has_value());
}

TEST_F(GlancerTest, OfTwoGeonsTheLargerInThePictureIsTold) {
  world_.objects.push_back(Cylinder({5.3, 5.5}));
  world_.objects.push_back(Cylinder({4.8, 3.5}));
  const auto by_floor = Made(exact_).GeonByFloorCamera(pose_, 1);
  ASSERT_TRUE(by_floor.has_value());
  const Vector2d foot_px = FloorPixel({4.8, 3.5});
  EXPECT_GT(foot_px.x(), by_floor->left_px);
  EXPECT_LT(foot_px.x(), by_floor->right_px);
}

TEST_F(GlancerTest, AllRoundMeasuresThePensWalls) {
  world_.pen_size_m = {3.0, 4.5};
  const Vector2d from_m(1.2, 1.7);
  const int count = 144;
  const auto distances_m = Made(exact_).AllRound(from_m, 0.3, count, 10.0);
  ASSERT_EQ(distances_m.size(), static_cast<size_t>(count));
  for (int k = 0; k < count; ++k) {
    const double angle_rad = 2.0 * kPi * k / count;
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    const double along_x_m = ((c > 0.0 ? 3.0 : 0.0) - from_m.x()) / c;
    const double along_y_m = ((s > 0.0 ? 4.5 : 0.0) - from_m.y()) / s;
    const double wall_m = std::min(std::abs(along_x_m), std::abs(along_y_m));
    EXPECT_NEAR(distances_m[static_cast<size_t>(k)], wall_m, 0.001) << k;
  }
}

TEST_F(GlancerTest, AllRoundLooksNoFartherThanAskedAndOverWhatIsLower) {
  world_.pen_size_m = {3.0, 4.5};
  for (const double distance_m : Made(exact_).AllRound({1.5, 2.2}, 0.3, 32, 1.0)) {
    EXPECT_DOUBLE_EQ(distance_m, 1.0);
  }
  for (const double distance_m : Made(exact_).AllRound({1.5, 2.2}, 0.9, 32, 8.0)) {
    EXPECT_DOUBLE_EQ(distance_m, 8.0) << "above the walls";
  }
}

TEST_F(GlancerTest, APolishedFloorGlaresWhereThePictureShowsTheLamp) {
  world_.lighting.lamp_W_m = {5.0, 6.0, 2.8};
  for (const GroundGlance& glance : Made(exact_).Floor(pose_, 1)) EXPECT_FALSE(glance.obstacle);
  world_.floor_gloss_1 = 0.01;
  for (const GroundGlance& glance : Made(exact_).Floor(pose_, 1)) EXPECT_FALSE(glance.obstacle);
  world_.floor_gloss_1 = 0.05;
  RendererOptions options = WithoutMountingErrors();
  options.floor.full_well_e = 1e12;  // no noise
  options.floor.read_noise_e = 0.0;
  const Frame picture = RigRenderer(scene(), TestRig(), options, 1).FloorColor(pose_, 1);
  const auto green = [&](const Vector2d& pixel_px) {
    const auto u = std::lround(pixel_px.x()), v = std::lround(pixel_px.y());
    return int{picture.pixels.at(static_cast<size_t>(3 * (v * picture.width_px + u) + 1))};
  };
  int glares = 0;
  for (const GroundGlance& glance : Made(exact_).Floor(pose_, 1)) {
    if (!glance.obstacle) continue;
    ++glares;
    EXPECT_TRUE(glance.bright);
    const Vector2d onward_px = (glance.end_px - glance.begin_px).normalized();
    EXPECT_GT(green(glance.end_px + 4.0 * onward_px), green(glance.end_px - 4.0 * onward_px) + 30);
  }
  EXPECT_GE(glares, 3);
}

TEST_F(GlancerTest, WhitePaintIsAsBrightAsGlareIs) {
  for (const bool white : {false, true}) {
    WorldObject box = Box({5.0, 3.3}, {0.6, 0.2, 0.4});
    if (white) box.color_rgb = {250.0, 250.0, 245.0};
    world_.objects = {box};
    int obstacles = 0;
    for (const GroundGlance& glance : Made(exact_).Floor(pose_, 1)) {
      if (!glance.obstacle) continue;
      ++obstacles;
      EXPECT_EQ(glance.bright, white);
    }
    EXPECT_GE(obstacles, 3);
  }
}

TEST_F(GlancerTest, WhatStandsBelowTheLampHidesItFromTheFloor) {
  world_.lighting.lamp_W_m = {5.0, 6.0, 2.8};
  world_.floor_gloss_1 = 0.05;
  WorldObject board = Box({5.0, 6.0}, {2.4, 2.4, 0.02});
  board.z_m = 2.6;
  world_.objects.push_back(board);
  for (const GroundGlance& glance : Made(exact_).Floor(pose_, 1)) EXPECT_FALSE(glance.obstacle);
}

TEST_F(GlancerTest, NoiseFollowsFromSeedAndSeq) {
  world_.objects.push_back(Box({5.0, 3.3}, {0.6, 0.2, 0.4}));
  world_.objects.push_back(Cylinder({5.6, 4.0}));
  const auto ends = [&](uint64_t seed, int64_t seq) {
    Glancer glancer = Made(GlanceOptions(), seed);
    std::vector<double> values;
    for (const GroundGlance& glance : glancer.Floor(pose_, seq)) {
      values.push_back(glance.end_px.x());
      values.push_back(glance.end_px.y());
    }
    const auto geon = glancer.GeonByFloorCamera(pose_, seq);
    EXPECT_TRUE(geon.has_value());
    if (geon) values.insert(values.end(), {geon->left_px, geon->right_px, geon->bottom_px});
    return values;
  };
  EXPECT_EQ(ends(1, 7), ends(1, 7));
  EXPECT_NE(ends(1, 7), ends(1, 8));
  EXPECT_NE(ends(1, 7), ends(2, 7));
}

TEST_F(GlancerTest, NoiseDoesNotDependOnWhatWasAskedBefore) {
  world_.objects.push_back(Box({5.0, 3.3}, {0.6, 0.2, 0.4}));
  Glancer fresh = Made(GlanceOptions()), used = Made(GlanceOptions());
  for (int64_t seq = 1; seq < 5; ++seq) used.Floor(pose_, seq);
  used.GeonByHead(pose_, 5);
  const auto a = fresh.Floor(pose_, 5), b = used.Floor(pose_, 5);
  ASSERT_EQ(a.size(), b.size());
  for (size_t k = 0; k < a.size(); ++k) EXPECT_EQ(a[k].end_px, b[k].end_px);
}

TEST_F(GlancerTest, NoiseOfAnEdgeIsAsLargeAsAsked) {
  world_.objects.push_back(Box({5.0, 3.3}, {1.2, 0.2, 0.4}));
  GlanceOptions noisy;
  noisy.edge_sigma_px = 2.0;
  const auto exact = Made(exact_).Floor(pose_, 0);
  Glancer glancer = Made(noisy);
  double squares_px2 = 0.0;
  int count = 0;
  for (int64_t seq = 0; seq < 40; ++seq) {
    const auto glances = glancer.Floor(pose_, seq);
    for (size_t k = 0; k < glances.size(); ++k) {
      if (!exact[k].obstacle) continue;
      squares_px2 += (glances[k].end_px - exact[k].end_px).squaredNorm();
      ++count;
    }
  }
  EXPECT_NEAR(std::sqrt(squares_px2 / count), 2.0, 0.2);
}

}  // namespace
}  // namespace geon::sim
