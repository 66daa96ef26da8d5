#include "sim/lamp_mirror.h"

#include <gtest/gtest.h>

#include "base/angles.h"
#include "sim/lighting.h"

namespace geon::sim {
namespace {

using Eigen::Vector3f;

const Vector3f kLamp_m(1.5F, 2.25F, 2.8F);
const Vector3f kEye_m(0.8F, 0.5F, 0.85F);

// The straight line from the eye to the lamp's image as far below the floor as the lamp is above.
Vector3f SpotOnFloor() {
  const Vector3f image_m = kLamp_m.cwiseProduct(Vector3f(1, 1, -1));
  return kEye_m + kEye_m.z() / (kEye_m.z() + kLamp_m.z()) * (image_m - kEye_m);
}

TEST(LampMirrorTest, TheImageIsAsBrightAsThePanelWhoseLightTheFloorGets) {
  // Of radiance L, seen from so far below: irradiance L A / h^2, and white shows that over pi.
  const double area_m2 = kLampPanel_m[0] * kLampPanel_m[1];
  EXPECT_NEAR(MirroredLamp_1(SpotOnFloor(), kEye_m, kLamp_m), kPi * 2.8 * 2.8 / area_m2, 0.01);
}

TEST(LampMirrorTest, TheImageOnTheFloorIsThePanelSmallerByTheHeights) {
  const Vector3f spot_m = SpotOnFloor();
  const float smaller_1 = 0.85F / (0.85F + 2.8F);
  const float crest = MirroredLamp_1(spot_m, kEye_m, kLamp_m);
  for (const int axis : {0, 1}) {
    const auto half_m = static_cast<float>(0.5 * kLampPanel_m[axis]);
    for (const float side : {-1.0F, 1.0F}) {
      const auto at = [&](float of_panel_m) {
        const Vector3f off_m = side * smaller_1 * of_panel_m * Vector3f::Unit(axis);
        return MirroredLamp_1(spot_m + off_m, kEye_m, kLamp_m);
      };
      EXPECT_FLOAT_EQ(at(half_m - 0.12F), crest);
      EXPECT_NEAR(at(half_m), 0.5F * crest, 0.01F * crest);
      EXPECT_EQ(at(half_m + 0.12F), 0.0F);
    }
  }
}

TEST(LampMirrorTest, AnEyeBelowTheMirrorSeesNothingInIt) {
  EXPECT_EQ(MirroredLamp_1({1.5F, 2.25F, 0.9F}, kEye_m, kLamp_m), 0.0F);
}

}  // namespace
}  // namespace geon::sim
