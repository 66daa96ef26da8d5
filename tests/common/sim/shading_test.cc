#include "sim/shading.h"

#include <gtest/gtest.h>

#include "tests/common/sim/scene_testing.h"

namespace geon::sim {
namespace {

std::vector<float> Shaded(const Scene& scene, const View& view, LampShadows shadows) {
  std::vector<float> light;
  ShadeColor(scene, view, shadows, &light);
  return light;
}

Eigen::Vector3f Pixel(const std::vector<float>& light, int u, int v) {
  const size_t k = 3 * static_cast<size_t>(v * 64 + u);
  return {light[k], light[k + 1], light[k + 2]};
}

TEST(ShadingTest, BoxThrowsASoftShadowOfTheLamp) {
  // A board that floats below the lamp (over the middle of the pen, 2.8 m high).
  const auto scene = SceneFrom("  - {box: [1.2, 1.2, 0.02], x_m: 1.5, y_m: 2.25, z_m: 2.3}\n");
  const View view = LookDown(*scene, 1.5, 2.25);
  const auto shadow = Shaded(*scene, view, LampShadows::kSoft);
  const auto none = Shaded(*scene, view, LampShadows::kNone);
  EXPECT_LT(Pixel(shadow, 32, 24).y(), 0.6F * Pixel(none, 32, 24).y());
  const auto plain = SceneFrom("");
  const auto lit = Shaded(*plain, LookDown(*plain, 0.8, 1.0), LampShadows::kSoft);
  const auto unshadowed = Shaded(*plain, LookDown(*plain, 0.8, 1.0), LampShadows::kNone);
  EXPECT_EQ(lit, unshadowed);
}

TEST(ShadingTest, GroovesAreDarkAndTilesAreNot) {
  const auto scene = SceneFrom("");
  const auto light = Shaded(*scene, LookDown(*scene, 1.8, 2.1), LampShadows::kNone);
  // x = 1.8 is a groove: between columns 31 and 32.
  const float groove = Pixel(light, 31, 10).y() + Pixel(light, 32, 10).y();
  const float tile = Pixel(light, 20, 10).y() + Pixel(light, 44, 10).y();
  EXPECT_LT(groove, 0.93F * tile);
}

TEST(ShadingTest, APolishedFloorShowsTheLampAndNothingElseChanges) {
  World world = WorldFrom("");
  const View matt_view = LookDown(**BuildScene(world), 1.5, 2.25);
  const auto matt = Shaded(**BuildScene(world), matt_view, LampShadows::kSoft);
  world.floor_gloss_1 = 0.05;
  const auto scene = *BuildScene(world);
  const View view =
      LookDown(*scene, 1.5, 2.25);  // right below the lamp: its image is in the middle
  const auto polished = Shaded(*scene, view, LampShadows::kSoft);
  // 0.6 of the light is the lamp's; the panel is pi h^2 / A as bright as white below it.
  const float lamp = 0.6F * 0.05F * static_cast<float>(kPi * 2.8 * 2.8 / (0.6 * 1.6));
  const Eigen::Vector3f gained = Pixel(polished, 32, 24) - Pixel(matt, 32, 24);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(gained[c], lamp, 0.01F);
  for (const auto& [u, v] : {std::pair{2, 24}, {60, 24}, {32, 2}, {32, 45}}) {
    EXPECT_EQ(Pixel(polished, u, v), Pixel(matt, u, v));
  }
  world.objects = WorldFrom("  - {box: [1.2, 2.4, 0.02], x_m: 1.5, y_m: 2.25, z_m: 2.6}\n").objects;
  const auto shadowed = *BuildScene(world);
  const auto hidden = Shaded(*shadowed, LookDown(*shadowed, 1.5, 2.25), LampShadows::kSoft);
  EXPECT_LT(Pixel(hidden, 32, 24).y(), Pixel(matt, 32, 24).y()) << "a board below the lamp";
}

TEST(ShadingTest, SunAddsItsLightWhereItShines) {
  const World dark = WorldFrom("", "{kelvin: 4000, level: 0.0}");
  const World sunny =
      WorldFrom("  - {box: [0.4, 0.4, 0.7], x_m: 1.5, y_m: 2.0}\n",
                "{kelvin: 4000, level: 0.0, sun: {level: 1.0, azimuth_deg: 0, elevation_deg: 45}}");
  const auto night = *BuildScene(dark), day = *BuildScene(sunny);
  EXPECT_EQ(Pixel(Shaded(*night, LookDown(*night, 1.5, 2.0), LampShadows::kSoft), 5, 24).norm(),
            0.0F);
  const auto light = Shaded(*day, LookDown(*day, 1.5, 2.0), LampShadows::kSoft);
  EXPECT_GT(Pixel(light, 62, 24).y(), 0.1F);  // towards the sun (+x)
  EXPECT_EQ(Pixel(light, 14, 24).y(), 0.0F);  // in the box's shadow
}

TEST(ShadingTest, RedAloneIsTheRedOfAColourPictureWithoutShadows) {
  const auto scene =
      SceneFrom("  - {geon: ellipsoid, size_m: [0.3, 0.2, 0.3], x_m: 1.5, y_m: 2.0}\n");
  const View view = LookDown(*scene, 1.5, 2.0);
  const std::vector<float> color = Shaded(*scene, view, LampShadows::kNone);
  std::vector<float> red;
  ShadeRed(*scene, view, &red);
  ASSERT_EQ(3 * red.size(), color.size());
  for (size_t k = 0; k < red.size(); ++k) EXPECT_EQ(red[k], color[3 * k + 2]);
}

TEST(ShadingTest, ColoursComeAsBlueGreenRed) {
  const auto scene =
      SceneFrom("  - {box: [1.0, 1.0, 0.3], x_m: 1.5, y_m: 2.0, color_rgb: [200, 100, 50]}\n");
  const Eigen::Vector3f middle =
      Pixel(Shaded(*scene, LookDown(*scene, 1.5, 2.0), LampShadows::kSoft), 32, 24);
  EXPECT_LT(middle[0], middle[1]);
  EXPECT_LT(middle[1], middle[2]);
}

}  // namespace
}  // namespace geon::sim
