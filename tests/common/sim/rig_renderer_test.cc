#include "sim/rig_renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "base/angles.h"
#include "sim/world_scene.h"
#include "tests/common/sim/scene_testing.h"

namespace geon::sim {
namespace {

int At(const Frame& frame, int u, int v, int channel = 0) {
  return frame.pixels[static_cast<size_t>((v * frame.width_px + u) * frame.channels + channel)];
}

// Centroid of lit minus unlit along a column (or row) in a window round its brightest pixel,
// written for this test alone. NaN where nothing shines.
std::vector<double> StripeCentroids(const Frame& lit, const Frame& unlit, bool horizontal) {
  std::vector<double> centroids;
  const int lines = horizontal ? lit.width_px : lit.height_px;
  const int length = horizontal ? lit.height_px : lit.width_px;
  for (int line = 0; line < lines; ++line) {
    const auto level = [&](int k) {
      const int u = horizontal ? line : k, v = horizontal ? k : line;
      return std::max(0, At(lit, u, v) - At(unlit, u, v));
    };
    int peak = 0;
    for (int k = 1; k < length; ++k) {
      if (level(k) > level(peak)) peak = k;
    }
    if (level(peak) < 30) {
      centroids.push_back(std::nan(""));
      continue;
    }
    double sum = 0.0, moment = 0.0;
    for (int k = std::max(0, peak - 6); k <= std::min(length - 1, peak + 6); ++k) {
      sum += level(k);
      moment += level(k) * k;
    }
    centroids.push_back(moment / sum);
  }
  return centroids;
}

// RMS of what is left after a straight line is fitted.
double StraightnessRms(const std::vector<double>& y) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (size_t k = 0; k < y.size(); ++k) {
    if (std::isnan(y[k])) continue;
    const auto x = static_cast<double>(k);
    n += 1, sx += x, sy += y[k], sxx += x * x, sxy += x * y[k];
  }
  const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx), offset = (sy - slope * sx) / n;
  double squares = 0;
  for (size_t k = 0; k < y.size(); ++k) {
    if (!std::isnan(y[k])) squares += std::pow(y[k] - offset - slope * static_cast<double>(k), 2);
  }
  return std::sqrt(squares / n);
}

class StripeOnBoardTest : public ::testing::TestWithParam<double> {};

TEST_P(StripeOnBoardTest, IsAsStraightAsOnARealRigAndNoStraighter) {
  RendererOptions options;
  options.mounting.lens_px = 0.0;  // which bends it
  RigRenderer renderer(SceneFrom(""), TestRig(), options, 4);
  const RigPose pose;
  renderer.SetScene(BoardScene(renderer.StripeCameraPose(pose), GetParam()));
  const Frame unlit = renderer.HeadBw(pose, {}, 1);
  for (const bool horizontal : {true, false}) {
    const Frame lit = renderer.HeadBw(pose, {horizontal ? 1.0 : 0.0, horizontal ? 0.0 : 1.0}, 2);
    const double rms_px = StraightnessRms(StripeCentroids(lit, unlit, horizontal));
    RecordProperty("rms_px", std::to_string(rms_px));
    EXPECT_GE(rms_px, 0.05) << "horizontal " << horizontal;
    EXPECT_LE(rms_px, 0.11) << "horizontal " << horizontal;
  }
}

INSTANTIATE_TEST_SUITE_P(Distances, StripeOnBoardTest, ::testing::Values(0.7, 1.0, 1.5, 2.0));

TEST(RigRendererTest, StripeLiesWhereTheFanMeetsTheBoard) {
  RigRenderer renderer(SceneFrom(""), TestRig(), WithoutMountingErrors(), 1);
  const RigPose pose;
  for (const double z_m : {0.75, 1.037, 1.6}) {
    renderer.SetScene(BoardScene(renderer.StripeCameraPose(pose), z_m));
    const auto v_px =
        StripeCentroids(renderer.HeadBw(pose, {1, 0}, 1), renderer.HeadBw(pose, {}, 2), true);
    // Similar triangles: the fan starts 0.125 m above the axis and crosses it at 1.037 m.
    const double expected_px = 239.5 - 1600.0 * 0.125 * (1.0 / z_m - 1.0 / 1.037);
    EXPECT_NEAR(std::accumulate(v_px.begin() + 100, v_px.begin() + 500, 0.0) / 400, expected_px,
                0.05);
  }
}

TEST(RigRendererTest, LaserThatBurnsForPartOfTheExposureIsFainter) {
  RigRenderer renderer(SceneFrom(""), TestRig(), WithoutMountingErrors(), 1);
  const RigPose pose;
  renderer.SetScene(BoardScene(renderer.StripeCameraPose(pose), 1.3));
  const auto total = [&](double fraction_1, int64_t seq) {
    const Frame frame = renderer.HeadBw(pose, {fraction_1, 0}, seq);
    return std::accumulate(frame.pixels.begin(), frame.pixels.end(), 0.0);
  };
  const double dark = total(0.0, 1);
  EXPECT_NEAR((total(0.4, 2) - dark) / (total(1.0, 3) - dark), 0.4, 0.03);
}

TEST(RigRendererTest, WhatStandsInTheLasersWayShadowsIt) {
  RigRenderer renderer(SceneFrom(""), TestRig(), WithoutMountingErrors(), 1);
  const RigPose pose;
  const geometry::RigidTransform X_WB = renderer.StripeCameraPose(pose);
  // The vertical laser stands 0.125 m to the left and its fan meets the axis, and the board,
  // at 1.037 m. A post half way, in the lower half of the picture, stands in the fan but left of
  // what the camera sees there.
  std::vector<Body> bodies = BoardScene(X_WB, 1.037)->bodies();
  Body post;
  post.name = "post";
  for (const auto& [x_m, y_m] :
       {std::pair{-0.08, 0.02}, {-0.04, 0.02}, {-0.04, 0.3}, {-0.08, 0.3}}) {
    post.surface_W.vertices_m.push_back(X_WB * Eigen::Vector3d(x_m, y_m, 0.52));
    post.surface_W.normals.push_back(-X_WB.linear().col(2));
  }
  post.surface_W.triangles = {{0, 2, 1}, {0, 3, 2}};
  bodies.push_back(post);
  renderer.SetScene(std::make_shared<Scene>(bodies, Lighting()));
  const Frame unlit = renderer.HeadBw(pose, {}, 1), lit = renderer.HeadBw(pose, {0, 1}, 2);
  const auto brightest_near_the_axis = [&](int v) {
    int level = 0;
    for (int u = 300; u < 340; ++u) level = std::max(level, At(lit, u, v) - At(unlit, u, v));
    return level;
  };
  for (int v = 60; v < 220; ++v) EXPECT_GT(brightest_near_the_axis(v), 60) << v;
  for (int v = 340; v < 460; ++v) EXPECT_LT(brightest_near_the_axis(v), 20) << v;
}

TEST(RigRendererTest, PaintedGeonPassesTheThesisColourRules) {
  RigPose pose;
  pose.X_WR = geometry::PlanarPose(1.5, 0.6, kPi / 2);
  pose.tilt_rad = RadiansFromDegrees(-25);
  RigRenderer renderer(
      SceneFrom("  - {geon: tapered_cylinder, size_m: [0.2, 0.2, 0.26], x_m: 1.5, y_m: 1.75}\n"),
      TestRig(), WithoutMountingErrors(), 1);
  const Frame frame = renderer.HeadColor(pose, 1);
  int super_red = 0, thesis_lab = 0, both = 0;
  for (int v = 0; v < frame.height_px; ++v) {
    for (int u = 0; u < frame.width_px; ++u) {
      const double b = At(frame, u, v, 0), g = At(frame, u, v, 1), r = At(frame, u, v, 2);
      const bool is_red = r >= b + g + 20;
      const bool is_lab = b < 0.467 * r - 7 && b < 75 && r > 50 && b < 1.333 * g + 10 &&
                          b > 1.333 * g - 86.7 && g < 115 && g < 0.639 * r - 12.78 &&
                          g > 0.381 * r - 45.7;
      super_red += is_red ? 1 : 0;
      thesis_lab += is_lab ? 1 : 0;
      both += is_red && is_lab ? 1 : 0;
    }
  }
  EXPECT_GT(both, 20000);
  EXPECT_GT(both, 0.97 * super_red);
  EXPECT_GT(both, 0.97 * thesis_lab);
}

TEST(RigRendererTest, SameSeedSameBytesAndOtherSeedOthers) {
  const std::string geon =
      "  - {geon: bent_cylinder, size_m: [0.08, 0.08, 0.3], x_m: 1.5, y_m: 1.75}\n";
  RigPose pose;
  pose.X_WR = geometry::PlanarPose(1.5, 0.6, kPi / 2);
  pose.tilt_rad = -0.4;
  RigRenderer first(SceneFrom(geon), TestRig(), RendererOptions(), 7);
  RigRenderer second(SceneFrom(geon), TestRig(), RendererOptions(), 7);
  RigRenderer other(SceneFrom(geon), TestRig(), RendererOptions(), 8);
  RigPose elsewhere = pose;
  elsewhere.pan_rad = 0.3;
  second.HeadBw(elsewhere, {0, 1}, 99);  // what was seen before must not matter
  second.HeadColor(elsewhere, 98);
  elsewhere.X_WR = geometry::PlanarPose(0.8, 1.2, 0.4);
  second.FloorColor(elsewhere, 97);
  EXPECT_EQ(first.HeadBw(pose, {1, 0}, 3).pixels, second.HeadBw(pose, {1, 0}, 3).pixels);
  EXPECT_EQ(first.HeadColor(pose, 3).pixels, second.HeadColor(pose, 3).pixels);
  EXPECT_EQ(first.FloorColor(pose, 3).pixels, second.FloorColor(pose, 3).pixels);
  EXPECT_NE(first.HeadColor(pose, 3).pixels, first.HeadColor(pose, 4).pixels);
  EXPECT_NE(first.HeadBw(pose, {1, 0}, 3).pixels, other.HeadBw(pose, {1, 0}, 3).pixels);
}

// Where in row v an edge near column `about` lies, from how much light there is in all on both
// sides of it. NaN too near the picture's sides.
double EdgeInRow(const Frame& frame, int about, int v) {
  constexpr int kHalf = 12;
  if (about < kHalf + 4 || about > frame.width_px - kHalf - 5) return std::nan("");
  const auto mean = [&](int from) {
    return (At(frame, from, v) + At(frame, from + 1, v) + At(frame, from + 2, v)) / 3.0;
  };
  const double left = mean(about - kHalf - 3), right = mean(about + kHalf + 1);
  double lit_left = 0.0;
  for (int u = about - kHalf; u <= about + kHalf; ++u) {
    lit_left += (right - At(frame, u, v)) / (right - left);
  }
  return about - kHalf - 0.5 + lit_left;
}

// An individual whose pixels tell the light as it is.
RendererOptions WithoutNoise() {
  RendererOptions options;
  for (CameraOptions* camera : {&options.color, &options.stripe}) {
    camera->read_noise_e = 0.0;
    camera->full_well_e = 1e12;
    camera->gamma_1 = 1.0;
  }
  return options;
}

TEST(RigRendererTest, ChessboardIsSeenWhereTheLensPutsIt) {
  const auto scene = SceneFrom(
      "  - {chessboard: {squares: [12, 9], square_m: 0.03}, x_m: 1.55, y_m: 1.85, z_m: 0.7, "
      "yaw_deg: -80, pitch_deg: 10}\n");
  const Checks& checks = scene->bodies().back().material.checks.value();
  RendererOptions options = WithoutNoise();
  options.mounting.lens_px = 4.0;
  RigRenderer renderer(scene, TestRig(), options, 6);
  const BuiltRig& rig = renderer.built_rig();
  RigPose pose;
  pose.X_WR = geometry::PlanarPose(1.5, 0.6, kPi / 2);
  pose.tilt_rad = RadiansFromDegrees(-2.0);
  for (const bool bw : {true, false}) {
    constexpr double kLong_1 = 100.0;  // a second, through the filter
    const Frame frame = bw ? renderer.HeadBw(pose, {}, 1, kLong_1) : renderer.HeadColor(pose, 1);
    const BuiltCamera& camera = bw ? rig.stripe_camera : rig.color_camera;
    const auto X_RC =
        bw ? rig.StripeCameraPose(0.0, pose.tilt_rad) : rig.ColorCameraPose(0.0, pose.tilt_rad);
    const geometry::RigidTransform X_CW = (pose.X_WR * X_RC).inverse();
    const auto on_board = [&](double column, double row) -> Eigen::Vector3d {
      return X_CW *
             (checks.corner_W_m + checks.square_m * (column * checks.along_W + row * checks.up_W));
    };
    double sum_px = 0.0, squares_px2 = 0.0, lens_px = 0.0;
    int edges = 0;
    for (int column = 1; column < checks.columns; ++column) {
      for (int row = 0; row < checks.rows; ++row) {
        const Eigen::Vector2d low_px = camera.Project(on_board(column, row + 0.4)),
                              high_px = camera.Project(on_board(column, row + 0.6));
        const int v = static_cast<int>(std::lround(0.5 * (low_px.y() + high_px.y())));
        if (v < 5 || v > 474) continue;
        const double true_u_px =
            low_px.x() + (v - low_px.y()) / (high_px.y() - low_px.y()) * (high_px.x() - low_px.x());
        const double u_px = EdgeInRow(frame, static_cast<int>(std::lround(true_u_px)), v);
        if (std::isnan(u_px)) continue;
        sum_px += u_px - true_u_px;
        squares_px2 += std::pow(u_px - true_u_px, 2);
        lens_px = std::max(lens_px, (camera.ideal.Project(on_board(column, row)) -
                                     camera.Project(on_board(column, row)))
                                        .norm());
        ++edges;
      }
    }
    ASSERT_GT(edges, 40) << bw;
    EXPECT_GT(lens_px, 0.6) << bw;
    EXPECT_NEAR(sum_px / edges, 0.0, 0.005) << bw;
    EXPECT_LT(std::sqrt(squares_px2 / edges), 0.025) << bw;  // half of it: 8 bits a pixel
  }
}

TEST(RigRendererTest, ALaserLightsTheSquaresOfAChessboardAsTheyArePainted) {
  const auto scene = SceneFrom(
      "  - {chessboard: {squares: [12, 9], square_m: 0.03}, x_m: 1.5, y_m: 1.65, z_m: 0.7, "
      "yaw_deg: -90}\n");
  RigRenderer renderer(scene, TestRig(), WithoutMountingErrors(), 6);
  RigPose pose;
  pose.X_WR = geometry::PlanarPose(1.5, 0.6, kPi / 2);
  pose.tilt_rad = RadiansFromDegrees(-3.0);
  const Frame unlit = renderer.HeadBw(pose, {}, 1), lit = renderer.HeadBw(pose, {1, 0}, 2);
  int bright = 0, dark = 0;
  for (int u = 40; u < 600; ++u) {
    int level = 0;
    for (int v = 0; v < 480; ++v) level = std::max(level, At(lit, u, v) - At(unlit, u, v));
    bright += level > 120 ? 1 : 0;
    dark += level < 40 ? 1 : 0;
  }
  EXPECT_NEAR(bright, 280, 60);
  EXPECT_NEAR(dark, 250, 60);
}

TEST(RigRendererTest, AMovingHeadSeesTheMeanOfWhereItWas) {
  const std::string geon = "  - {geon: cuboid, size_m: [0.2, 0.2, 0.26], x_m: 1.5, y_m: 1.75}\n";
  RigRenderer renderer(SceneFrom(geon), TestRig(), WithoutNoise(), 7);
  RigPose first;
  first.X_WR = geometry::PlanarPose(1.5, 0.6, kPi / 2);
  first.tilt_rad = -0.4;
  RigPose second = first;
  second.pan_rad = 0.01;
  RigPath path;
  path.poses = {first, second};
  const Frame colors[] = {renderer.HeadColor(first, 1), renderer.HeadColor(second, 1),
                          renderer.HeadColor(path, 1)};
  const Frame stripes[] = {renderer.HeadBw(first, {1, 0}, 1, 10.0),
                           renderer.HeadBw(second, {1, 0}, 1, 10.0),
                           renderer.HeadBw(path, {1, 0}, 1, 10.0)};
  for (const auto& frames : {colors, stripes}) {
    int different = 0;
    for (size_t k = 0; k < frames[0].pixels.size(); ++k) {
      const int a = frames[0].pixels[k], b = frames[1].pixels[k], mean = frames[2].pixels[k];
      if (a == 255 || b == 255) continue;  // full: the mean is not that of the pictures
      EXPECT_NEAR(mean, 0.5 * (a + b), 1.5);
      different += std::abs(a - b) > 20 ? 1 : 0;
    }
    EXPECT_GT(different, 300);
  }
}

// Sum of squared differences between a picture moved by (right, down) pixels and another.
double Misfit(const Frame& frame, const std::vector<double>& other, int right, int down) {
  double squares = 0.0;
  for (int v = 1; v < frame.height_px - 1; ++v) {
    for (int u = 1; u < frame.width_px - 1; ++u) {
      const auto pixel = static_cast<size_t>((v + down) * frame.width_px + u + right) * 3 + 2;
      squares += std::pow(At(frame, u, v, 2) - other[pixel], 2);
    }
  }
  return squares;
}

TEST(RigRendererTest, AFastHeadSmearsWhatItSeesAndPutsItWhereItIs) {
  const std::string geon = "  - {geon: cuboid, size_m: [0.2, 0.2, 0.26], x_m: 1.5, y_m: 1.75}\n";
  RigRenderer renderer(SceneFrom(geon), TestRig(), WithoutNoise(), 7);
  RigPath path;
  path.poses.clear();
  std::vector<double> mean(640 * 480 * 3, 0.0);
  std::vector<double> middle;
  for (int k = 0; k < 8; ++k) {
    RigPose pose;
    pose.X_WR = geometry::PlanarPose(1.5, 0.6, kPi / 2);
    pose.tilt_rad = -0.4;
    pose.pan_rad = 0.01 / 7.0 * k;  // 16 px
    path.poses.push_back(pose);
    const Frame sharp = renderer.HeadColor(pose, 1);
    for (size_t i = 0; i < mean.size(); ++i) mean[i] += sharp.pixels[i] / 8.0;
    if (k == 4) middle.assign(sharp.pixels.begin(), sharp.pixels.end());
  }
  const Frame smeared = renderer.HeadColor(path, 1);
  const double least = Misfit(smeared, mean, 0, 0);
  EXPECT_LT(std::sqrt(least / (640.0 * 480.0)), 3.0);  // levels
  EXPECT_LT(least, 0.2 * Misfit(smeared, middle, 0, 0));
  // Where the misfit is least, by a parabola through three of them.
  const auto off_px = [&](int right, int down) {
    const double before = Misfit(smeared, mean, -right, -down);
    const double after = Misfit(smeared, mean, right, down);
    return 0.5 * (before - after) / (before + after - 2.0 * least);
  };
  EXPECT_NEAR(off_px(1, 0), 0.0, 0.5);
  EXPECT_NEAR(off_px(0, 1), 0.0, 0.5);
}

TEST(RigRendererTest, FloorCameraSeesTheFloorInItsColour) {
  RigPose pose;
  pose.X_WR = geometry::PlanarPose(1.5, 1.0, kPi / 2);
  RigRenderer renderer(SceneFrom(""), TestRig(), WithoutMountingErrors(), 1);
  const Frame frame = renderer.FloorColor(pose, 1);
  EXPECT_EQ(frame.width_px, 320);
  double sums[3] = {0, 0, 0};
  for (int v = 120; v < 200; ++v) {
    for (int u = 100; u < 220; ++u) {
      for (int c = 0; c < 3; ++c) sums[c] += At(frame, u, v, c) / 9600.0;
    }
  }
  EXPECT_NEAR(sums[2], 143, 12);
  EXPECT_NEAR(sums[0] / sums[2], 140.0 / 150.0, 0.01);
}

}  // namespace
}  // namespace geon::sim
