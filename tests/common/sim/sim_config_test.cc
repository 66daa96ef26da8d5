#include "sim/sim_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/angles.h"

namespace geon::sim {
namespace {

using ::testing::HasSubstr;

TEST(SimConfigTest, TheProductsFileSaysTheDefaults) {
  const Result<SimOptions> options = LoadSimOptions(GEON_SOURCE_DIR "/scripts/config/sim.yaml");
  ASSERT_TRUE(options.ok()) << options.message();
  const RendererOptions defaults;
  EXPECT_DOUBLE_EQ(options->renderer.lasers.crest_1, defaults.lasers.crest_1);
  EXPECT_DOUBLE_EQ(options->renderer.lasers.speckle_1, defaults.lasers.speckle_1);
  EXPECT_DOUBLE_EQ(options->renderer.stripe.white_1, defaults.stripe.white_1);
  EXPECT_DOUBLE_EQ(options->renderer.stripe.rate_hz, defaults.stripe.rate_hz);
  EXPECT_NEAR(options->renderer.mounting.laser_rad, defaults.mounting.laser_rad, 1e-12);
}

TEST(SimConfigTest, WhatIsGivenIsTaken) {
  const Result<SimOptions> options = ParseSimOptions(
      "mounting: {laser_deg: 0.5}\nstripe_camera: {rate_hz: 20, exposure_us: 5000, dropped_1: "
      "0.02}\n"
      "odometry: {turn_scale_1: 1.02}\nline_faults: {ptu: \"drop_1=0.25\"}\n",
      "sim.yaml");
  ASSERT_TRUE(options.ok()) << options.message();
  EXPECT_NEAR(options->renderer.mounting.laser_rad, RadiansFromDegrees(0.5), 1e-12);
  EXPECT_DOUBLE_EQ(options->renderer.stripe.rate_hz, 20.0);
  EXPECT_DOUBLE_EQ(options->renderer.stripe.dropped_1, 0.02);
  EXPECT_DOUBLE_EQ(options->renderer.floor.dropped_1, 0.0);
  EXPECT_DOUBLE_EQ(options->base.drive.odometry_turn_scale_1, 1.02);
  EXPECT_DOUBLE_EQ(options->ptu_faults.drop_1, 0.25);
}

TEST(SimConfigTest, RefusesWithFileLineAndReason) {
  EXPECT_THAT(ParseSimOptions("lasers: {crest: 1}\n", "sim.yaml").message(),
              AllOf(HasSubstr("sim.yaml:1"), HasSubstr("crest")));
  EXPECT_THAT(ParseSimOptions("stripe_camera: {exposure_us: 95000}\n", "sim.yaml").message(),
              HasSubstr("exposure_us"));
  EXPECT_THAT(ParseSimOptions("floor_camera: {dropped_1: -0.1}\n", "sim.yaml").message(),
              AllOf(HasSubstr("floor_camera"), HasSubstr("dropped_1")));
  EXPECT_THAT(ParseSimOptions("line_faults: {base: \"drops=1\"}\n", "sim.yaml").message(),
              HasSubstr("base"));
}

}  // namespace
}  // namespace geon::sim
