#include "sim/view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/common/sim/scene_testing.h"

namespace geon::sim {
namespace {

// Looks straight down from 2 m above a point of the floor.
View LookDown(const Scene& scene, double x_m, double y_m) {
  geometry::PinholeCamera camera{64, 48, 80.0, 80.0, 31.5, 23.5};
  Eigen::Matrix3d R_WC;
  R_WC << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  View view;
  LookThrough(scene, camera, geometry::MakeTransform(R_WC, {x_m, y_m, 2.0}), &view);
  return view;
}

Eigen::Vector3f Pixel(const std::vector<float>& light, int u, int v) {
  const size_t k = 3 * static_cast<size_t>(v * 64 + u);
  return {light[k], light[k + 1], light[k + 2]};
}

TEST(ViewTest, PixelsMeetTheFloorWhereTheirRaysSay) {
  const auto scene = SceneFrom("");
  const View view = LookDown(*scene, 1.5, 2.0);
  const Sighting& corner = view.sightings[0];
  EXPECT_NEAR(static_cast<double>(corner.p_W_m.x()), 1.5 - 31.5 / 80 * 2.0, 1e-5);
  EXPECT_NEAR(static_cast<double>(corner.p_W_m.y()), 2.0 + 23.5 / 80 * 2.0, 1e-5);
  EXPECT_EQ(corner.body, 0);
}

TEST(ViewTest, BoxThrowsASoftShadowOfTheLamp) {
  // A board that floats below the lamp (over the middle of the pen, 2.8 m high).
  const auto scene = SceneFrom("  - {box: [1.2, 1.2, 0.02], x_m: 1.5, y_m: 2.25, z_m: 2.3}\n");
  const View view = LookDown(*scene, 1.5, 2.25);
  const auto shadow = ShadeColor(*scene, view, LampShadows::kSoft);
  const auto none = ShadeColor(*scene, view, LampShadows::kNone);
  EXPECT_LT(Pixel(shadow, 32, 24).y(), 0.6F * Pixel(none, 32, 24).y());
  const auto plain = SceneFrom("");
  const auto lit = ShadeColor(*plain, LookDown(*plain, 0.8, 1.0), LampShadows::kSoft);
  const auto unshadowed = ShadeColor(*plain, LookDown(*plain, 0.8, 1.0), LampShadows::kNone);
  EXPECT_EQ(lit, unshadowed);
}

TEST(ViewTest, GroovesAreDarkAndTilesAreNot) {
  const auto scene = SceneFrom("");
  const auto light = ShadeColor(*scene, LookDown(*scene, 1.8, 2.1), LampShadows::kNone);
  // x = 1.8 is a groove: between columns 31 and 32.
  const float groove = Pixel(light, 31, 10).y() + Pixel(light, 32, 10).y();
  const float tile = Pixel(light, 20, 10).y() + Pixel(light, 44, 10).y();
  EXPECT_LT(groove, 0.93F * tile);
}

TEST(ViewTest, SunAddsItsLightWhereItShines) {
  const World dark = WorldFrom("", "{kelvin: 4000, level: 0.0}");
  const World sunny =
      WorldFrom("  - {box: [0.4, 0.4, 0.7], x_m: 1.5, y_m: 2.0}\n",
                "{kelvin: 4000, level: 0.0, sun: {level: 1.0, azimuth_deg: 0, elevation_deg: 45}}");
  const auto night = *BuildScene(dark), day = *BuildScene(sunny);
  EXPECT_EQ(Pixel(ShadeColor(*night, LookDown(*night, 1.5, 2.0), LampShadows::kSoft), 5, 24).norm(),
            0.0F);
  const auto light = ShadeColor(*day, LookDown(*day, 1.5, 2.0), LampShadows::kSoft);
  EXPECT_GT(Pixel(light, 62, 24).y(), 0.1F);  // towards the sun (+x)
  EXPECT_EQ(Pixel(light, 14, 24).y(), 0.0F);  // in the box's shadow
}

}  // namespace
}  // namespace geon::sim
