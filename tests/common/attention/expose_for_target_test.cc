#include "attention/expose_for_target.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/contracts.h"

namespace geon::attention {
namespace {

constexpr int kSide_px = 20;

sensor::Image Picture(const std::vector<uint8_t>& rgb_of_pixels) {
  sensor::Image image;
  image.width_px = kSide_px;
  image.height_px = kSide_px;
  image.row_stride_bytes = 3 * kSide_px;
  image.format = sensor::PixelFormat::kRgb8;
  image.data = rgb_of_pixels;
  return image;
}

// A grey picture with a square of 10 x 10 red pixels, and its mask.
struct RedSquare {
  sensor::Image image;
  std::vector<uint8_t> mask;
};
RedSquare MakeRedSquare(uint8_t grey, uint8_t red) {
  RedSquare square;
  std::vector<uint8_t> pixels;
  for (int v = 0; v < kSide_px; ++v) {
    for (int u = 0; u < kSide_px; ++u) {
      const bool inside = u >= 5 && u < 15 && v >= 5 && v < 15;
      square.mask.push_back(inside ? 255 : 0);
      for (const uint8_t level :
           {inside ? red : grey, inside ? uint8_t{20} : grey, inside ? uint8_t{30} : grey}) {
        pixels.push_back(level);
      }
    }
  }
  square.image = Picture(pixels);
  return square;
}

// A camera before a target of so much light: the level it shows.
double LevelOf(double light_1, double exposure_s, double gamma_1) {
  return std::min(255.0, 255.0 * std::pow(light_1 * exposure_s / 0.010, 1.0 / gamma_1));
}

TEST(ExposeForTargetTest, LightOfTheTargetIsItsBrightestHundredthWhateverIsAround) {
  const RedSquare square = MakeRedSquare(250, 120);
  const SeenLight seen = MeasureLight(square.image, square.mask);
  EXPECT_TRUE(seen.of_target);
  EXPECT_EQ(seen.level_1, 120.0);
}

TEST(ExposeForTargetTest, OneHighlightedPixelInAHundredIsLeftOut) {
  RedSquare square = MakeRedSquare(80, 120);
  const size_t pixel = 3U * (7 * kSide_px + 7);
  std::fill_n(square.image.data.begin() + static_cast<std::ptrdiff_t>(pixel), 3, uint8_t{255});
  EXPECT_EQ(MeasureLight(square.image, square.mask).level_1, 120.0);
}

TEST(ExposeForTargetTest, WithoutATargetThePicturesMedianCounts) {
  const RedSquare square = MakeRedSquare(77, 250);
  for (const std::vector<uint8_t>& mask :
       {std::vector<uint8_t>{}, std::vector<uint8_t>(kSide_px * kSide_px, 0)}) {
    const SeenLight seen = MeasureLight(square.image, mask);
    EXPECT_FALSE(seen.of_target);
    EXPECT_EQ(seen.level_1, 77.0);
  }
}

TEST(ExposeForTargetTest, EverySceneOfSevenStopsIsExposedRightWithinSixFrames) {
  const ExposureOptions options;
  for (const double camera_gamma_1 : {1.8, 2.2, 2.4}) {
    for (double stops = -3.0; stops <= 4.0; stops += 0.25) {
      const double light_1 = std::exp2(stops);
      double exposure_s = 0.010;
      for (int frame = 0; frame < 6; ++frame) {
        exposure_s =
            NextExposure(exposure_s, {true, LevelOf(light_1, exposure_s, camera_gamma_1)}, options);
      }
      const double level_1 = LevelOf(light_1, exposure_s, camera_gamma_1);
      EXPECT_GE(level_1, options.low_level_1) << stops << " stops, gamma " << camera_gamma_1;
      EXPECT_LE(level_1, options.high_level_1) << stops << " stops, gamma " << camera_gamma_1;
    }
  }
}

TEST(ExposeForTargetTest, ExposureStaysWhileTheLevelIsRight) {
  for (const double level_1 : {200.0, 210.0, 235.0}) {
    EXPECT_EQ(NextExposure(0.010, {true, level_1}, {}), 0.010);
  }
  EXPECT_EQ(NextExposure(0.010, {false, 110.0}, {}), 0.010);
  EXPECT_GT(NextExposure(0.010, {true, 110.0}, {}), 0.010)
      << "right for a scene, dark for a target";
}

TEST(ExposeForTargetTest, ExposureKeepsItsLimits) {
  ExposureOptions options;
  options.most_exposure_s = 0.012;
  EXPECT_EQ(NextExposure(0.010, {true, 20.0}, options), 0.012);
  options.least_exposure_s = 0.008;
  EXPECT_EQ(NextExposure(0.010, {true, 255.0}, options), 0.008);
  EXPECT_EQ(NextExposure(0.001, {true, 0.0}, {}), 0.004) << "one step is at most fourfold";
}

TEST(ExposeForTargetTest, BrokenContractsThrow) {
  ExposureOptions options;
  options.aim_level_1 = 240.0;
  EXPECT_THROW((void)NextExposure(0.010, {true, 100.0}, options), ContractViolation);
  EXPECT_THROW((void)NextExposure(0.0, {true, 100.0}, {}), ContractViolation);
  const RedSquare square = MakeRedSquare(80, 120);
  EXPECT_THROW((void)MeasureLight(square.image, std::vector<uint8_t>(7)), ContractViolation);
}

}  // namespace
}  // namespace geon::attention
