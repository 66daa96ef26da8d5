#include "attention/adapt_color_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/contracts.h"

namespace geon::attention {
namespace {

constexpr Rgb kFloor{150, 150, 140};

sensor::Image Filled(const Rgb& color, int width_px, sensor::PixelFormat format) {
  sensor::Image image;
  image.width_px = width_px;
  image.height_px = 10;
  image.row_stride_bytes = 3 * width_px;
  image.format = format;
  for (int k = 0; k < 10 * width_px; ++k) {
    const bool red_first = format == sensor::PixelFormat::kRgb8;
    image.data.insert(image.data.end(), {red_first ? color.red : color.blue, color.green,
                                         red_first ? color.blue : color.red});
  }
  return image;
}

Rgb Under(const Rgb& color, const LightGain& gain) {
  const auto level = [](double value) {
    return static_cast<uint8_t>(std::lround(std::min(255.0, value)));
  };
  return {level(color.red * gain.red_1), color.green, level(color.blue * gain.blue_1)};
}

TEST(AdaptColorModelTest, GainIsReadOffTheFloorInEitherChannelOrder) {
  const LightGain warm{1.2, 0.7};
  for (const auto format : {sensor::PixelFormat::kRgb8, sensor::PixelFormat::kBgr8}) {
    const auto gain = MeasureLightGain(Filled(Under(kFloor, warm), 20, format), kFloor);
    ASSERT_TRUE(gain.has_value());
    EXPECT_NEAR(gain->red_1, 1.2, 0.01);
    EXPECT_NEAR(gain->blue_1, 0.7, 0.01);
  }
}

TEST(AdaptColorModelTest, ThingsOnTheFloorDoNotMoveTheGain) {
  sensor::Image image = Filled(kFloor, 20, sensor::PixelFormat::kRgb8);
  for (size_t k = 0; k < 3 * 20 * 4; k += 3) image.data[k] = 220;  // 4 rows of 10 are pink
  const auto gain = MeasureLightGain(image, kFloor);
  ASSERT_TRUE(gain.has_value());
  EXPECT_NEAR(gain->red_1, 1.0, 0.01);
}

TEST(AdaptColorModelTest, DarkAndClippedPicturesSayNothing) {
  for (const Rgb& color : {Rgb{20, 20, 20}, Rgb{255, 240, 230}}) {
    EXPECT_FALSE(
        MeasureLightGain(Filled(color, 20, sensor::PixelFormat::kRgb8), kFloor).has_value());
  }
}

TEST(AdaptColorModelTest, AdaptedModelSeesUnderTheLightWhatTheModelSeesWithoutIt) {
  const ColorModel model{"red", {{{{50, -60, -10, 0}, {20, -10, -80, 0}, {1, 1, 1, 40}}}}, {}};
  const LightGain warm{1.15, 0.75};
  const ColorModel adapted = AdaptColorModel(model, warm);
  int in = 0, differ = 0, all = 0;
  for (int red = 60; red < 220; red += 4) {
    for (int green = 10; green < 200; green += 4) {
      for (int blue = 10; blue < 200; blue += 4, ++all) {
        const Rgb color{static_cast<uint8_t>(red), static_cast<uint8_t>(green),
                        static_cast<uint8_t>(blue)};
        const bool wanted = model.Classify(color) == ColorClass::kTarget;
        in += wanted ? 1 : 0;
        differ += wanted != (adapted.Classify(Under(color, warm)) == ColorClass::kTarget) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(in, all / 50);
  EXPECT_LT(differ, all / 50) << "colours on the rim, by rounding";
}

TEST(AdaptColorModelTest, NeutralPictureShowsTheColorOfThePaint) {
  const LightGain cold{0.85, 1.3};
  const Rgb paint{150, 40, 40};
  for (const auto format : {sensor::PixelFormat::kRgb8, sensor::PixelFormat::kBgr8}) {
    const sensor::Image neutral = UnderNeutralLight(Filled(Under(paint, cold), 20, format), cold);
    const sensor::Image wanted = Filled(paint, 20, format);
    for (size_t k = 0; k < wanted.data.size(); ++k) EXPECT_NEAR(neutral.data[k], wanted.data[k], 1);
  }
}

TEST(AdaptColorModelTest, BrokenContractsThrow) {
  EXPECT_THROW((void)AdaptColorModel({}, {0.0, 1.0}), ContractViolation);
  const sensor::Image image = Filled(kFloor, 20, sensor::PixelFormat::kRgb8);
  EXPECT_THROW((void)MeasureLightGain(image, {0, 100, 100}), ContractViolation);
  EXPECT_THROW((void)UnderNeutralLight(image, {1.0, 0.0}), ContractViolation);
}

}  // namespace
}  // namespace geon::attention
