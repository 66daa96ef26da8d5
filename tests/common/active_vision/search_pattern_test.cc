#include "active_vision/search_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/contracts.h"
#include "geometry/rigid_transform.h"

namespace geon::active_vision {
namespace {

const geometry::PinholeCamera kCamera;
constexpr double kHorizontalView_rad = 0.3948;  // 2 atan(320 / 1600)

// Whether a camera on the head's axes sees a direction given by its own pan and tilt.
bool Sees(const HeadAngles& look, const HeadAngles& direction) {
  const auto axes = [](const HeadAngles& head) -> Eigen::Matrix3d {
    return geometry::RotationAboutZ(head.pan_rad) * geometry::RotationAboutY(-head.tilt_rad);
  };
  const Eigen::Vector3d ray_P = axes(direction) * Eigen::Vector3d::UnitX();
  const Eigen::Vector3d ray_C =
      geometry::CameraAxesInBody().transpose() * axes(look).transpose() * ray_P;
  return ray_C.z() > 0.0 && kCamera.Contains(kCamera.Project(ray_C));
}

TEST(SearchPatternTest, EveryDirectionOfTheAreaIsSeen) {
  const SearchOptions options;
  const HeadLimits limits;
  const auto looks = SearchPattern(kCamera, limits, {}, options);
  for (int i = 0; i <= 60; ++i) {
    for (int j = 0; j <= 60; ++j) {
      const HeadAngles direction{
          options.pan_min_rad + (options.pan_max_rad - options.pan_min_rad) * i / 60.0,
          options.tilt_min_rad + (options.tilt_max_rad - options.tilt_min_rad) * j / 60.0};
      EXPECT_TRUE(std::any_of(looks.begin(), looks.end(),
                              [&](const HeadAngles& look) { return Sees(look, direction); }))
          << DegreesFromRadians(direction.pan_rad) << ", "
          << DegreesFromRadians(direction.tilt_rad);
    }
  }
}

TEST(SearchPatternTest, HeadMovesByLessThanAViewBetweenLooks) {
  const auto looks = SearchPattern(kCamera, {}, {});
  ASSERT_GT(looks.size(), 4U);
  for (size_t i = 1; i < looks.size(); ++i) {
    EXPECT_LT(std::abs(looks[i].pan_rad - looks[i - 1].pan_rad), kHorizontalView_rad);
    EXPECT_LT(std::abs(looks[i].tilt_rad - looks[i - 1].tilt_rad), kHorizontalView_rad);
    EXPECT_NE(looks[i], looks[i - 1]);
  }
}

TEST(SearchPatternTest, StartsAtTheBottomOnTheSideNearerToTheHead) {
  const auto from_left = SearchPattern(kCamera, {}, {0.5, 0.0});
  const auto from_right = SearchPattern(kCamera, {}, {-0.5, 0.0});
  EXPECT_GT(from_left.front().pan_rad, 0.0);
  EXPECT_LT(from_right.front().pan_rad, 0.0);
  EXPECT_LT(from_left.front().tilt_rad, from_left.back().tilt_rad);
}

TEST(SearchPatternTest, AreaSmallerThanAViewTakesOneLookAtItsMiddle) {
  const SearchOptions options{0.1, 0.2, -0.3, -0.2, 0.25, 0.25};
  const auto looks = SearchPattern(kCamera, {}, {}, options);
  ASSERT_EQ(looks.size(), 1U);
  EXPECT_NEAR(looks[0].pan_rad, 0.15, 1e-12);
  EXPECT_NEAR(looks[0].tilt_rad, -0.25, 1e-12);
}

TEST(SearchPatternTest, PicturesTakenWithinTheToleranceOfEveryLookStillSeeEverything) {
  SearchOptions options;
  options.pan_overlap_1 = 0.5;
  auto looks = SearchPattern(kCamera, {}, {}, options);
  const HeadAngles tolerance = LookTolerance(kCamera, options);
  for (size_t i = 0; i < looks.size(); ++i) {
    looks[i].pan_rad += (i % 2 == 0 ? 0.99 : -0.99) * tolerance.pan_rad;
  }
  for (int i = 5; i <= 55; ++i) {
    const HeadAngles direction{
        options.pan_min_rad + (options.pan_max_rad - options.pan_min_rad) * i / 60.0, -0.4};
    EXPECT_TRUE(std::any_of(looks.begin(), looks.end(), [&](const HeadAngles& look) {
      return Sees(look, direction);
    })) << DegreesFromRadians(direction.pan_rad);
  }
}

TEST(SearchPatternTest, LooksStayWithinTheLimits) {
  const HeadLimits narrow{-0.3, 0.2, -0.4, 0.0};
  for (const HeadAngles& look : SearchPattern(kCamera, narrow, {})) {
    EXPECT_TRUE(narrow.Contain(look));
  }
}

TEST(SearchPatternTest, AreaTurnedInsideOutThrows) {
  const SearchOptions options{0.5, -0.5, 0.0, 0.1, 0.25, 0.25};
  EXPECT_THROW(SearchPattern(kCamera, {}, {}, options), ContractViolation);
}

}  // namespace
}  // namespace geon::active_vision
