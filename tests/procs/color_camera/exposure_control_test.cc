#include "procs/color_camera/exposure_control.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geon::color_camera {
namespace {

ExposureControlOptions OptionsForRed() {
  ExposureControlOptions options;
  options.target_color = *attention::NamedColorModel("super-red");
  options.first_exposure_s = 0.010;
  return options;
}

// Grey all over, but for a red square of 40 x 40 pixels unless `red` is 0.
sensor::Image LitFrame(int32_t seq, uint8_t grey, uint8_t red,
                       std::optional<double> exposure_s = std::nullopt) {
  constexpr int kSide_px = 100;
  sensor::Image image;
  image.seq = seq;
  image.width_px = image.height_px = kSide_px;
  image.row_stride_bytes = 3 * kSide_px;
  image.format = sensor::PixelFormat::kBgr8;
  image.exposure_s = exposure_s;
  for (int v = 0; v < kSide_px; ++v) {
    for (int u = 0; u < kSide_px; ++u) {
      const bool inside = red > 0 && u >= 30 && u < 70 && v >= 30 && v < 70;
      const auto rest = static_cast<uint8_t>(red / 4);
      const uint8_t target[] = {rest, rest, red};
      for (const uint8_t level : target) image.data.push_back(inside ? level : grey);
    }
  }
  return image;
}

TEST(ExposureControl, ExposesForTheTargetWhateverIsAround) {
  ExposureControl control(OptionsForRed());
  const auto asked_s = control.Judge(LitFrame(1, 240, 120));
  ASSERT_TRUE(asked_s.has_value());
  EXPECT_NEAR(*asked_s, 0.010 * std::pow(218.0 / 120.0, 2.2), 1e-9);
  EXPECT_FALSE(ExposureControl(OptionsForRed()).Judge(LitFrame(1, 20, 215)).has_value());
}

TEST(ExposureControl, ExposesForATargetTooFaintToHaveItsColour) {
  // Not red enough for "super-red", but it would be at 2.5 times the level.
  ExposureControl control(OptionsForRed());
  const sensor::Image frame = LitFrame(1, 130, 60, 0.010);
  sensor::Image faint = frame;
  for (size_t k = 0; k < faint.data.size(); k += 3) {
    if (faint.data[k + 2] == 60) faint.data[k] = faint.data[k + 1] = 22;  // 60 < 22 + 22 + 20
  }
  EXPECT_NEAR(control.Judge(faint).value(), 0.010 * 4.0, 1e-9) << "the most of one step";
  for (size_t k = 0; k < faint.data.size(); k += 3) {
    if (faint.data[k + 2] == 60) faint.data[k] = faint.data[k + 1] = 29;  // brown, however bright
  }
  EXPECT_FALSE(ExposureControl(OptionsForRed()).Judge(faint).has_value());
}

TEST(ExposureControl, WithoutATargetThePictureCounts) {
  ExposureControl control(OptionsForRed());
  EXPECT_NEAR(control.Judge(LitFrame(1, 70, 0)).value(), 0.010 * std::pow(130.0 / 70.0, 2.2), 1e-9);
}

TEST(ExposureControl, WaitsForFramesTakenAfterTheRequest) {
  ExposureControl control(OptionsForRed());
  ASSERT_TRUE(control.Judge(LitFrame(5, 55, 0)).has_value());
  for (const int32_t seq : {6, 7, 8}) {
    EXPECT_FALSE(control.Judge(LitFrame(seq, 55, 0)).has_value()) << seq;
  }
  EXPECT_FALSE(control.Judge(LitFrame(9, 110, 0)).has_value()) << "now it is good";
  EXPECT_TRUE(control.Judge(LitFrame(10, 55, 0)).has_value()) << "the light went out";
}

TEST(ExposureControl, StartsFromTheExposureTheFrameStates) {
  ExposureControl control(OptionsForRed());
  EXPECT_NEAR(control.Judge(LitFrame(1, 70, 0, 0.004)).value(), 0.004 * std::pow(130.0 / 70.0, 2.2),
              1e-9);
  // The request came to nothing: the frames still state the exposure before, and it is made again.
  EXPECT_NEAR(control.Judge(LitFrame(5, 70, 0, 0.004)).value(), 0.004 * std::pow(130.0 / 70.0, 2.2),
              1e-9);
}

TEST(ExposureControl, ACameraThatStartsAnewIsJudgedAtOnce) {
  ExposureControl control(OptionsForRed());
  ASSERT_TRUE(control.Judge(LitFrame(500, 55, 0)).has_value());
  EXPECT_TRUE(control.Judge(LitFrame(1, 55, 0, 0.010)).has_value());
}

TEST(ExposureControl, KeepsToItsRange) {
  ExposureControlOptions options = OptionsForRed();
  options.law.most_exposure_s = 0.012;
  ExposureControl control(options);
  EXPECT_EQ(control.Judge(LitFrame(1, 10, 0)), 0.012);
  EXPECT_FALSE(control.Judge(LitFrame(9, 10, 0)).has_value()) << "it can do no more";
}

}  // namespace
}  // namespace geon::color_camera
