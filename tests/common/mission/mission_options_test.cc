#include "mission/mission_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/mission/fake_world.h"

namespace geon::mission {
namespace {

using testing::HasSubstr;

std::string RuleBrokenBy(const std::function<void(MissionOptions*)>& change) {
  MissionOptions options = FastOptions();
  std::string rule = "none";
  EXPECT_TRUE(options.IsValid(&rule)) << rule;
  change(&options);
  EXPECT_FALSE(options.IsValid(&rule));
  return rule;
}

TEST(MissionOptionsTest, StateTheRuleThatIsBroken) {
  EXPECT_THAT(RuleBrokenBy([](auto* o) { o->looking.support_heights_m = {1.5}; }),
              HasSubstr("support_heights_m"));
  EXPECT_THAT(RuleBrokenBy([](auto* o) { o->looking.stop_distance_m = 0.3; }),
              HasSubstr("stop_distance_m"));
  EXPECT_THAT(RuleBrokenBy([](auto* o) { o->driving.safe_polygon.clearance_m = 0.28; }),
              HasSubstr("radius"));
  EXPECT_THAT(RuleBrokenBy([](auto* o) { o->patience.mission_s = 0.0; }), HasSubstr("time"));
  EXPECT_THAT(RuleBrokenBy([](auto* o) { o->patience.min_stripes = 7; }), HasSubstr("min_stripes"));
  EXPECT_THAT(RuleBrokenBy([](auto* o) { o->driving.wander_s = std::nan(""); }),
              HasSubstr("positive"));
  EXPECT_THAT(RuleBrokenBy([](auto* o) { o->looking.sweep.pan_min_rad = 2.0; }),
              HasSubstr("sweep"));
  EXPECT_THAT(RuleBrokenBy([](auto* o) { o->destination_W_m = Eigen::Vector2d(0.0, -11.5); }),
              HasSubstr("destination must lie within 11"));
  EXPECT_THAT(
      RuleBrokenBy([](auto* o) { o->destination_W_m = Eigen::Vector2d(std::nan(""), 0.0); }),
      HasSubstr("destination"));
}

}  // namespace
}  // namespace geon::mission
