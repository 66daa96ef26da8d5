#include "sim/camera_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geon::sim {
namespace {

using ::testing::HasSubstr;

TEST(RendererOptionsTest, DefaultsAreValid) { EXPECT_TRUE(Validate(RendererOptions()).ok()); }

TEST(RendererOptionsTest, NamesTheCameraAndTheRuleThatIsBroken) {
  RendererOptions options;
  options.stripe.exposure_us = 95000.0;  // at 30 Hz
  EXPECT_THAT(Validate(options).message(),
              AllOf(HasSubstr("stripe_camera"), HasSubstr("exposure_us")));
  options = RendererOptions();
  options.floor.gamma_1 = 0.5;
  EXPECT_THAT(Validate(options).message(), AllOf(HasSubstr("floor_camera"), HasSubstr("gamma_1")));
  options = RendererOptions();
  options.color.dropped_1 = 1.5;
  EXPECT_THAT(Validate(options).message(),
              AllOf(HasSubstr("color_camera"), HasSubstr("dropped_1")));
  options = RendererOptions();
  options.lasers.divergence_m = 0.0;
  EXPECT_THAT(Validate(options).message(), HasSubstr("divergence_m"));
  options = RendererOptions();
  options.mounting.focal_1 = -0.1;
  EXPECT_THAT(Validate(options).message(), HasSubstr("mounting"));
}

}  // namespace
}  // namespace geon::sim
