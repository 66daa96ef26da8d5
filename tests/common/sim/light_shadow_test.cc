#include "sim/light_shadow.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/lighting.h"
#include "sim/random_world.h"
#include "tests/common/sim/scene_testing.h"

namespace geon::sim {
namespace {

// Pixels at which the answer is another than that of a ray to the pixel's quarter of the light, and
// how many lie in the shadow.
struct ShadowCount {
  int wrong = 0;
  int dark = 0;
};
struct Panel {
  Eigen::Vector3f middle_W_m;
  Eigen::Vector2d size_m;
};
Panel LampOf(const Scene& scene) {
  return {scene.lighting().lamp_W_m.cast<float>(), {kLampPanel_m[0], kLampPanel_m[1]}};
}
void CountAgainstRays(const Scene& scene, const Panel& panel, const geometry::PinholeCamera& camera,
                      const geometry::RigidTransform& X_WC, ShadowCount* count) {
  View view;
  LookThrough(scene, camera, X_WC, &view);
  const Eigen::Vector3f light_W_m = panel.middle_W_m;
  const Eigen::Vector2f quarter_m = (0.25 * panel.size_m).cast<float>();
  LightShadow shadow(scene, light_W_m, panel.size_m);
  SurfaceRow row;
  std::vector<uint8_t> lit(static_cast<size_t>(camera.width_px));
  for (int v = 0; v < camera.height_px; ++v) {
    ResolveRow(scene, view, v, 0, camera.width_px, &row);
    shadow.Ask(row, v, lit);
    for (const SurfaceRow::Run& run : row.runs) {
      for (int u = run.begin; u < run.end; ++u) {
        uint8_t answer = 1;
        const Eigen::Vector3f point = row.Point(u);
        if (run.body >= 0 && row.Normal(u).dot(light_W_m - point) > 0.0F) {
          const Eigen::Vector3f quarter =
              light_W_m + Eigen::Vector3f(u % 2 == 0 ? -quarter_m.x() : quarter_m.x(),
                                          v % 2 == 0 ? -quarter_m.y() : quarter_m.y(), 0);
          scene.Illuminate(quarter, {&point, 1}, {&answer, 1});
        }
        count->wrong += answer != lit[static_cast<size_t>(u)] ? 1 : 0;
        count->dark += lit[static_cast<size_t>(u)] == 0 ? 1 : 0;
      }
    }
  }
}

TEST(LightShadowTest, IsThatOfRaysInRandomWorlds) {
  const geometry::SensorRig rig = TestRig();
  ShadowCount of_lamp, of_sun;
  for (const uint64_t seed : {7u, 31u, 32u, 33u}) {
    const World world = RandomWorld(seed, GeonPlace::kAny);
    const WorldObject& geon = world.objects.back();
    const auto X_WR = geometry::PlanarPose(geon.x_m - 1.2, geon.y_m, 0.0);
    const double tilt_rad =
        RadiansFromDegrees(15.0) - std::atan2(1.2 - FootHeight(world, geon), 1.2);
    const auto scene = *BuildScene(world);
    const auto X_WC = X_WR * rig.ColorCameraPose(0.05, tilt_rad);
    CountAgainstRays(*scene, LampOf(*scene), rig.color_camera, X_WC, &of_lamp);
    const Panel sun = {{150.0F - 40.0F * static_cast<float>(seed % 4), 90.0F, 80.0F}, {0.0, 0.0}};
    CountAgainstRays(*scene, sun, rig.color_camera, X_WC, &of_sun);
  }
  EXPECT_EQ(of_lamp.wrong, 0);
  EXPECT_GT(of_lamp.dark, 5000);
  EXPECT_EQ(of_sun.wrong, 0);
  EXPECT_GT(of_sun.dark, 5000);
}

TEST(LightShadowTest, IsThatOfRaysBelowAndAboveWhatFloatsOrReachesTheLamp) {
  for (const char* objects :
       {"  - {box: [1.2, 1.2, 0.02], x_m: 1.5, y_m: 2.25, z_m: 1.5}\n",
        "  - {box: [0.3, 0.2, 3.5], x_m: 1.6, y_m: 2.4, yaw_deg: 30}\n",
        "  - {cylinder: {radius_m: 0.002, height_m: 1.5}, x_m: 1.2, y_m: 2.0}\n"}) {
    const auto scene = SceneFrom(objects);
    const View floor = LookDown(*scene, 1.1, 1.9);
    ShadowCount count;
    CountAgainstRays(*scene, LampOf(*scene), {320, 240, 160.0, 160.0, 159.5, 119.5}, floor.X_WC,
                     &count);
    EXPECT_EQ(count.wrong, 0) << objects;
    EXPECT_GT(count.dark, 10) << objects;
  }
}

}  // namespace
}  // namespace geon::sim
