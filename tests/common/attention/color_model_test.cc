#include "attention/color_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace geon::attention {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

bool IsTarget(const ColorModel& model, const Rgb& pixel) {
  return model.Classify(pixel) == ColorClass::kTarget;
}

ColorModel Named(const std::string& name) { return NamedColorModel(name).value(); }

// The printed inequalities once more, literally, so that a slip in the table shows.
bool ThesisLab(double r, double g, double b) {
  return b < 0.467 * r - 7 && b < 75 && r > 50 && b < 1.333 * g + 10 && b > 1.333 * g - 86.7 &&
         g < 115 && g < 0.639 * r - 12.78 && g > 0.381 * r - 45.7;
}
bool ThesisLabSun(double r, double g, double b) {
  return b < 0.75 * r - 5 && b < 80 && r > 50 && b < 1.333 * g + 10 && b > 0.67 * g - 40 &&
         g < 100 && g > 0.44 * r - 50.6 && g > 30 && g < 0.58 * r + 25.2;
}

TEST(ColorModelTest, NamesAreKnownAndOthersAreNot) {
  EXPECT_THAT(NamedColorModels(), ElementsAre("super-red", "thesis-lab", "thesis-lab-sun"));
  EXPECT_FALSE(NamedColorModel("super-green"));
}

TEST(ColorModelTest, SuperRedExceedsTheOthersByMoreThanTwenty) {
  EXPECT_FALSE(IsTarget(Named("super-red"), {120, 50, 50}));
  EXPECT_TRUE(IsTarget(Named("super-red"), {121, 50, 50}));
}

TEST(ColorModelTest, ThesisModelsHoldThePrintedInequalitiesForEveryColor) {
  const ColorModel lab = Named("thesis-lab");
  const ColorModel sun = Named("thesis-lab-sun");
  int in_lab = 0;
  int in_sun = 0;
  for (int r = 0; r < 256; r += 3) {
    for (int g = 0; g < 256; g += 3) {
      for (int b = 0; b < 256; b += 3) {
        const Rgb pixel{static_cast<uint8_t>(r), static_cast<uint8_t>(g), static_cast<uint8_t>(b)};
        ASSERT_EQ(IsTarget(lab, pixel), ThesisLab(r, g, b)) << r << " " << g << " " << b;
        ASSERT_EQ(IsTarget(sun, pixel), ThesisLabSun(r, g, b)) << r << " " << g << " " << b;
        in_lab += IsTarget(lab, pixel) ? 1 : 0;
        in_sun += IsTarget(sun, pixel) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(in_lab, 100);
  EXPECT_GT(in_sun, in_lab) << "the region was made larger for sunlight";
}

TEST(ColorModelTest, FirstClassThatHoldsCounts) {
  const ColorModel model{"red",
                         {{{{1, -1, -1, 20}}}, {{{0, 0, 1, 240}, {-1, 0, 0, -10}}}},
                         {{{{1, -1, 0, 20}}}},
                         30,
                         250};
  EXPECT_EQ(model.Classify({100, 20, 20}), ColorClass::kTarget);
  EXPECT_EQ(model.Classify({255, 20, 20}), ColorClass::kTarget) << "clipped, but target";
  EXPECT_EQ(model.Classify({9, 20, 241}), ColorClass::kTarget) << "the second region";
  EXPECT_EQ(model.Classify({100, 20, 90}), ColorClass::kRim);
  EXPECT_EQ(model.Classify({28, 2, 27}), ColorClass::kRim) << "dark, but rim";
  EXPECT_EQ(model.Classify({29, 29, 29}), ColorClass::kCannotTell);
  EXPECT_EQ(model.Classify({0, 250, 0}), ColorClass::kCannotTell);
  EXPECT_EQ(model.Classify({30, 249, 0}), ColorClass::kOther);
}

TEST(ColorModelTest, BadModelsAreNamed) {
  const ColorModel good = Named("super-red");
  EXPECT_EQ(good.Validate(), std::nullopt);
  const auto error = [](ColorModel model, const auto& spoil) {
    spoil(model);
    return model.Validate().value_or("");
  };
  EXPECT_THAT(error(good, [](ColorModel& model) { model.target.clear(); }), HasSubstr("at least"));
  EXPECT_THAT(error(good, [](ColorModel& model) { model.rim.emplace_back(); }),
              HasSubstr("no half-space"));
  EXPECT_THAT(error(good, [](ColorModel& model) { model.target[0].half_spaces[0].red_1 = NAN; }),
              HasSubstr("not finite"));
  EXPECT_THAT(error(good, [](ColorModel& model) { model.dark_level_1 = 256; }),
              HasSubstr("dark_level_1 is 256"));
  EXPECT_THAT(error(good, [](ColorModel& model) { model.clipped_level_1 = 0; }),
              HasSubstr("clipped_level_1 is 0"));
}

TEST(ColorModelTest, AtALevelItHoldsTheSameColoursAsManyTimesFainter) {
  ColorModel model = *NamedColorModel("thesis-lab");
  model.rim = NamedColorModel("super-red")->target;
  model.dark_level_1 = 40;
  const ColorModel half = AtLevel(model, 0.5);
  for (int red = 0; red < 256; red += 6) {
    for (int green = 0; green < 256; green += 10) {
      for (int blue = 0; blue < 256; blue += 10) {
        const auto at_half = [](int level) { return static_cast<uint8_t>(level / 2); };
        const Rgb bright{static_cast<uint8_t>(red), static_cast<uint8_t>(green),
                         static_cast<uint8_t>(blue)};
        ASSERT_EQ(half.Classify({at_half(red), at_half(green), at_half(blue)}),
                  model.Classify(bright))
            << red << ' ' << green << ' ' << blue;
      }
    }
  }
  EXPECT_EQ(AtLevel(model, 1.0), model);
  EXPECT_THROW(AtLevel(model, 0.0), ContractViolation);
}

TEST(ColorModelTest, WholeNumberedPlaneIsNearAndSmall) {
  const ColorHalfSpace plane{0.31, -1.7, 0.9, 11.0};
  const ColorHalfSpace whole = WholeNumbered(plane);
  for (const double number : {whole.red_1, whole.green_1, whole.blue_1, whole.threshold_1}) {
    EXPECT_EQ(number, std::round(number));
  }
  EXPECT_LE(std::abs(whole.red_1) + std::abs(whole.green_1) + std::abs(whole.blue_1), 128.0);
  EXPECT_NEAR(whole.red_1 / whole.green_1, plane.red_1 / plane.green_1, 0.01);
  EXPECT_NEAR(whole.blue_1 / whole.green_1, plane.blue_1 / plane.green_1, 0.01);
  EXPECT_NEAR(whole.threshold_1 / whole.green_1, plane.threshold_1 / plane.green_1, 0.05);
}

}  // namespace
}  // namespace geon::attention
