#include "attention/color_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geon::attention {
namespace {

using testing::ElementsAre;

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
  EXPECT_FALSE(Named("super-red").Contains({120, 50, 50}));
  EXPECT_TRUE(Named("super-red").Contains({121, 50, 50}));
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
        ASSERT_EQ(lab.Contains(pixel), ThesisLab(r, g, b)) << r << " " << g << " " << b;
        ASSERT_EQ(sun.Contains(pixel), ThesisLabSun(r, g, b)) << r << " " << g << " " << b;
        in_lab += lab.Contains(pixel) ? 1 : 0;
        in_sun += sun.Contains(pixel) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(in_lab, 100);
  EXPECT_GT(in_sun, in_lab) << "the region was made larger for sunlight";
}

TEST(ColorModelTest, ChromaticityModelKeepsItsColorAtAnyBrightnessAboveItsLimit) {
  const Yiq yiq = YiqFromRgb({200, 50, 50});
  const ColorModel model{
      "red", ChromaticityColor{yiq.in_phase_1 / yiq.luminance_1, yiq.quadrature_1 / yiq.luminance_1,
                               400.0, 0.0, 400.0, 2.0, 20.0}};
  EXPECT_TRUE(model.Contains({200, 50, 50}));
  EXPECT_TRUE(model.Contains({100, 25, 25}));
  EXPECT_FALSE(model.Contains({40, 10, 10})) << "luminance 19";
  EXPECT_FALSE(model.Contains({200, 100, 50}));
  EXPECT_FALSE(model.Contains({0, 0, 0}));
}

}  // namespace
}  // namespace geon::attention
