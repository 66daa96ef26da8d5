#include "attention/learn_color_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "attention/find_target.h"
#include "base/contracts.h"

namespace geon::attention {
namespace {

using testing::HasSubstr;

struct Lit {
  double red = 1.0, green = 1.0, blue = 1.0;  // gain of the light
};

// A disc of one paint before a wall of another, shaded from bright to dark, with camera noise.
TeachingSample Scene(const Rgb& paint, const Rgb& wall, const Lit& light, unsigned seed) {
  constexpr int kWidth = 120;
  constexpr int kHeight = 90;
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 3.0);
  TeachingSample sample;
  sample.image.width_px = kWidth;
  sample.image.height_px = kHeight;
  sample.image.row_stride_bytes = 3 * kWidth;
  sample.image.format = sensor::PixelFormat::kRgb8;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const bool is_target = (u - 60) * (u - 60) + (v - 45) * (v - 45) < 30 * 30;
      const double shade = 0.5 + 0.5 * u / kWidth;
      const Rgb& color = is_target ? paint : wall;
      for (const double level :
           {color.red * light.red, color.green * light.green, color.blue * light.blue}) {
        sample.image.data.push_back(
            static_cast<uint8_t>(std::clamp(level * shade + noise(random), 0.0, 255.0)));
      }
      sample.is_target.push_back(is_target ? 255 : 0);
    }
  }
  return sample;
}

double OverlapOf(const ColorModel& model, const TeachingSample& scene) {
  const TargetSighting sighting = FindTarget(scene.image, model);
  double both = 0.0;
  double either = 0.0;
  for (size_t i = 0; i < sighting.mask.size(); ++i) {
    both += sighting.mask[i] != 0 && scene.is_target[i] != 0;
    either += sighting.mask[i] != 0 || scene.is_target[i] != 0;
  }
  return both / either;
}

constexpr Rgb kPaint{170, 40, 45};
constexpr Rgb kWall{150, 130, 110};

TEST(LearnColorModelTest, LearnedModelFindsTheTargetAgain) {
  const auto learned = LearnColorModel({Scene(kPaint, kWall, {}, 1)}, "paint");
  ASSERT_TRUE(learned.ok()) << learned.message();
  EXPECT_EQ(learned->model.name, "paint");
  EXPECT_GT(learned->report.recall_1, 0.97);
  EXPECT_GT(learned->report.precision_1, 0.99);
  EXPECT_TRUE(learned->report.warnings.empty());
  EXPECT_GT(OverlapOf(learned->model, Scene(kPaint, kWall, {}, 2)), 0.85);
}

TEST(LearnColorModelTest, LearnedModelHoldsWhenTheLightGetsWeaker) {
  const auto learned = LearnColorModel({Scene(kPaint, kWall, {}, 1)}, "paint");
  ASSERT_TRUE(learned.ok());
  EXPECT_GT(OverlapOf(learned->model, Scene(kPaint, kWall, {0.7, 0.7, 0.7}, 3)), 0.8);
}

TEST(LearnColorModelTest, ColorsOtherThanRedCanBeTaught) {
  const Rgb green{50, 140, 60};
  const auto learned = LearnColorModel({Scene(green, kWall, {}, 4)}, "green");
  ASSERT_TRUE(learned.ok());
  EXPECT_GT(OverlapOf(learned->model, Scene(green, kWall, {}, 5)), 0.85);
  EXPECT_NEAR(learned->report.mean_color.hue_rad, 2.2, 0.2) << "green is at 120 degrees";
}

TEST(LearnColorModelTest, BoxThatHoldsSomeBackgroundTeachesTheTarget) {
  TeachingSample boxed = Scene(kPaint, kWall, {}, 6);
  for (int v = 15; v < 75; ++v) {
    for (int u = 30; u < 90; ++u) boxed.is_target[static_cast<size_t>(v * 120 + u)] = 255;
  }
  const auto learned = LearnColorModel({boxed}, "paint");
  ASSERT_TRUE(learned.ok()) << learned.message();
  EXPECT_GT(OverlapOf(learned->model, Scene(kPaint, kWall, {}, 7)), 0.85);
}

TEST(LearnColorModelTest, TwoLightsInTheLessonWidenTheModel) {
  const Lit warm{1.1, 1.0, 0.7};
  const auto one = LearnColorModel({Scene(kPaint, kWall, {}, 8)}, "one");
  const auto both =
      LearnColorModel({Scene(kPaint, kWall, {}, 8), Scene(kPaint, kWall, warm, 9)}, "both");
  ASSERT_TRUE(one.ok() && both.ok());
  const TeachingSample scene = Scene(kPaint, kWall, warm, 10);
  EXPECT_GT(OverlapOf(both->model, scene), 0.8);
  EXPECT_GE(OverlapOf(both->model, scene), OverlapOf(one->model, scene));
}

TEST(LearnColorModelTest, PaintLikeTheWallIsWarnedOfOrRefused) {
  const Rgb almost_wall{156, 128, 108};
  const auto learned = LearnColorModel({Scene(almost_wall, kWall, {}, 11)}, "paint");
  if (learned.ok()) {
    ASSERT_FALSE(learned->report.warnings.empty());
    EXPECT_THAT(learned->report.warnings.front(), HasSubstr("background"));
  } else {
    EXPECT_THAT(learned.message(), HasSubstr("no colour marks it"));
  }
  EXPECT_THAT(LearnColorModel({Scene(kWall, kWall, {}, 12)}, "wall").message(),
              HasSubstr("no colour marks it"));
}

TEST(LearnColorModelTest, ClippedOrDarkTargetsAreNotLearnedFrom) {
  EXPECT_THAT(LearnColorModel({Scene({0, 0, 0}, kWall, {}, 13)}, "black").message(),
              HasSubstr("too dark"));
  const Rgb glaring{255, 120, 120};
  const auto learned = LearnColorModel({Scene(glaring, kWall, {1.5, 1.0, 1.0}, 14)}, "glare");
  ASSERT_TRUE(learned.ok()) << learned.message();
  EXPECT_GT(learned->report.clipped_fraction_1, 0.3);
  ASSERT_FALSE(learned->report.warnings.empty());
  EXPECT_THAT(learned->report.warnings.front(), HasSubstr("clipped"));
}

TEST(LearnColorModelTest, BrokenContractsThrow) {
  TeachingSample sample = Scene(kPaint, kWall, {}, 15);
  sample.is_target.pop_back();
  EXPECT_THROW((void)LearnColorModel({sample}, "short"), ContractViolation);
  TeachingOptions options;
  options.background_weight_1 = 0.0;
  EXPECT_THROW((void)LearnColorModel({}, "none", options), ContractViolation);
}

}  // namespace
}  // namespace geon::attention
