#include "sim/sonar_echo.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/common/sim/device_testing.h"
#include "tests/common/sim/scene_testing.h"

namespace geon::sim {
namespace {

using geometry::RigidTransform;

// A transducer at the origin of W that looks along x, turned to the left and up.
RigidTransform Looking(double left_deg, double up_deg = 0.0) {
  return geometry::MakeTransform(geometry::RotationAboutZ(RadiansFromDegrees(left_deg)) *
                                     geometry::RotationAboutY(RadiansFromDegrees(-up_deg)),
                                 {0.0, 0.0, 0.55});
}
Walls SquareWall(double away_m, double reflectance_1 = 0.8) {
  return Walls({{{-1.0, 0.0}, -away_m}}, reflectance_1);
}

// Only the part of a wall across the x axis, 1 m away, that lies left of `from_y_m`.
class Panel : public Walls {
 public:
  Panel(double slant_rad, double from_y_m)
      : Walls({{{-std::cos(slant_rad), -std::sin(slant_rad)}, -std::cos(slant_rad)}}),
        from_y_m_(from_y_m) {}
  std::optional<RayHit> CastRay(const Eigen::Vector3d& origin_W_m,
                                const Eigen::Vector3d& direction_W, double reach_m) const override {
    const auto hit = Walls::CastRay(origin_W_m, direction_W, reach_m);
    if (!hit || (origin_W_m + hit->distance_m * direction_W).y() < from_y_m_) return std::nullopt;
    return hit;
  }

 private:
  double from_y_m_;
};

// A single upright pole of the radius of the thesis's cylinders.
class Pole : public FreeSpace {
 public:
  explicit Pole(double away_m) : axis_m_(away_m + kRadius_m, 0.0) {}
  std::optional<RayHit> CastRay(const Eigen::Vector3d& origin_W_m,
                                const Eigen::Vector3d& direction_W, double) const override {
    const Eigen::Vector2d to_axis_m = axis_m_ - origin_W_m.head<2>();
    const Eigen::Vector2d direction = direction_W.head<2>().normalized();
    const double along_m = to_axis_m.dot(direction);
    const double off2 = to_axis_m.squaredNorm() - along_m * along_m;
    if (along_m < 0.0 || off2 > kRadius_m * kRadius_m) return std::nullopt;
    const double flat_m = along_m - std::sqrt(kRadius_m * kRadius_m - off2);
    const Eigen::Vector2d normal =
        (origin_W_m.head<2>() + flat_m * direction - axis_m_) / kRadius_m;
    return RayHit{flat_m / direction_W.head<2>().norm(), {normal.x(), normal.y(), 0.0}, 0.8};
  }
  static constexpr double kRadius_m = 0.075;

 private:
  Eigen::Vector2d axis_m_;
};

TEST(SonarEchoTest, OneWallReadsTheSameFromAllItsSideLobes) {
  // Cao and Borenstein 2002: out to 42 degrees.
  const Walls wall = SquareWall(1.2);
  for (const double off_deg : {0.0, 10.0, 20.0, 30.0, 41.0, -20.0, -41.0}) {
    const auto echo_m = SonarEcho_m(wall, Looking(off_deg), {});
    ASSERT_TRUE(echo_m.has_value()) << off_deg;
    EXPECT_NEAR(*echo_m, 1.2, 1e-6) << off_deg << ": the foot of the perpendicular";
  }
  for (const double off_deg : {44.0, -44.0, 60.0}) {
    EXPECT_FALSE(SonarEcho_m(wall, Looking(off_deg), {}).has_value()) << off_deg;
  }
}

TEST(SonarEchoTest, ASlantedWallFartherOffSendsTheSoundAway) {
  const Walls wall = SquareWall(2.6);
  EXPECT_TRUE(SonarEcho_m(wall, Looking(0.0), {}).has_value());
  EXPECT_TRUE(SonarEcho_m(wall, Looking(15.0), {}).has_value());
  EXPECT_FALSE(SonarEcho_m(wall, Looking(25.0), {}).has_value());
  EXPECT_FALSE(SonarEcho_m(wall, Looking(41.0), {}).has_value());
}

TEST(SonarEchoTest, AWallMetSquarelyIsHeardToTheEndOfItsReach) {
  EXPECT_TRUE(SonarEcho_m(SquareWall(10.6), Looking(0.0), {}).has_value());
  EXPECT_FALSE(SonarEcho_m(SquareWall(10.8), Looking(0.0), {}).has_value());
  // As far again with four times the strength.
  EXPECT_TRUE(SonarEcho_m(SquareWall(21.2), Looking(0.0), {}, 4.0).has_value());
  EXPECT_FALSE(SonarEcho_m(SquareWall(21.6), Looking(0.0), {}, 4.0).has_value());
}

TEST(SonarEchoTest, NoColourIsHeard) {
  for (const double reflectance_1 : {0.02, 0.9}) {
    EXPECT_TRUE(SonarEcho_m(SquareWall(9.0, reflectance_1), Looking(0.0), {}).has_value());
  }
}

TEST(SonarEchoTest, ATiltedBeamStillHearsAnUprightWall) {
  const Walls wall = SquareWall(3.0);
  for (const double up_deg : {-2.0, 2.0}) {
    const auto echo_m = SonarEcho_m(wall, Looking(0.0, up_deg), {});
    ASSERT_TRUE(echo_m.has_value());
    EXPECT_NEAR(*echo_m, 3.0, 1e-6);
  }
}

TEST(SonarEchoTest, APlaneThatEndsBeforeTheFootOfThePerpendicularIsHeardAtItsEdgeOnly) {
  const Panel panel(0.0, 0.05);  // the foot would be at y = 0
  const auto echo_m = SonarEcho_m(panel, Looking(0.0), {});
  ASSERT_TRUE(echo_m.has_value());
  EXPECT_NEAR(*echo_m, 1.0, 0.01);
  SonarEchoOptions no_edges;
  no_edges.scatter_1 = 0.0;
  EXPECT_FALSE(SonarEcho_m(panel, Looking(0.0), no_edges).has_value());
  EXPECT_TRUE(SonarEcho_m(Panel(0.0, -0.10), Looking(0.0), no_edges).has_value());
}

TEST(SonarEchoTest, TheEdgeOfASlantedPanelAnswersFaintly) {
  const Panel panel(kPi / 3, 0.0);  // its edge 1 m ahead, its plane 60 degrees off square
  const auto echo_m = SonarEcho_m(panel, Looking(0.0), {});
  ASSERT_TRUE(echo_m.has_value());
  EXPECT_NEAR(*echo_m, 1.0, 0.08);
  SonarEchoOptions quiet;
  quiet.scatter_1 = 0.005;
  EXPECT_FALSE(SonarEcho_m(panel, Looking(0.0), quiet).has_value());
}

TEST(SonarEchoTest, APoleIsHeardLessFarThanAWall) {
  for (const double away_m : {0.5, 1.0, 2.0, 3.0}) {
    const auto echo_m = SonarEcho_m(Pole(away_m), Looking(0.0), {});
    ASSERT_TRUE(echo_m.has_value()) << away_m;
    EXPECT_NEAR(*echo_m, away_m, 0.06);
  }
  EXPECT_FALSE(SonarEcho_m(Pole(5.0), Looking(0.0), {}).has_value());
  EXPECT_FALSE(SonarEcho_m(Pole(1.0), Looking(30.0), {}).has_value()) << "beside the beam";
}

TEST(SonarEchoTest, ACornerAnswersByWayOfBothWalls) {
  // Looked into along its bisector: each wall is met at 45 degrees.
  const double s = std::sqrt(0.5);
  const Walls corner({{{-s, s}, -1.2}, {{-s, -s}, -1.2}});
  const auto echo_m = SonarEcho_m(corner, Looking(0.0), {});
  ASSERT_TRUE(echo_m.has_value());
  EXPECT_NEAR(*echo_m, 1.2 / s, 0.1) << "as if something stood in the corner";
  SonarEchoOptions without;
  without.corner_1 = 0.0;
  EXPECT_FALSE(SonarEcho_m(corner, Looking(0.0), without).has_value());
}

// A box of 0.45 m, its front 1 m before a transducer at 0.55 m; the pen's wall is 2.5 m behind it.
TEST(SonarEchoTest, ABoxBelowTheBeamIsHeardAtItsRimWhenItStandsSquare) {
  const auto echo = [](const std::string& yaw_deg, const SonarEchoOptions& options) {
    const auto scene =
        SceneFrom("  - {box: [0.9, 0.9, 0.45], x_m: 1.5, y_m: 2.45, yaw_deg: " + yaw_deg + "}\n");
    const RigidTransform X_WS =
        geometry::MakeTransform(geometry::RotationAboutZ(kPi / 2), {1.5, 1.0, 0.55});
    return SonarEcho_m(*scene, X_WS, options);
  };
  ASSERT_TRUE(echo("0", {}).has_value());
  EXPECT_NEAR(*echo("0", {}), 1.0, 0.02);
  SonarEchoOptions no_edges;
  no_edges.scatter_1 = 0.0;
  ASSERT_TRUE(echo("0", no_edges).has_value());
  EXPECT_NEAR(*echo("0", no_edges), 3.5, 0.01) << "the wall, over the box";
}

TEST(SonarEchoTest, TheFloorIsNotHeard) {
  class Floor : public FreeSpace {
   public:
    std::optional<RayHit> CastRay(const Eigen::Vector3d& origin_W_m,
                                  const Eigen::Vector3d& direction_W, double) const override {
      if (direction_W.z() >= 0.0) return std::nullopt;
      return RayHit{-origin_W_m.z() / direction_W.z(), Eigen::Vector3d::UnitZ(), 0.5};
    }
  };
  for (const double up_deg : {0.0, -2.0}) {
    EXPECT_FALSE(SonarEcho_m(Floor(), Looking(0.0, up_deg), {}).has_value());
  }
}

}  // namespace
}  // namespace geon::sim
