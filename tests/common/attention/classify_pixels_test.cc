#include "attention/classify_pixels.h"

#include <gtest/gtest.h>

#include "base/contracts.h"
#include "tests/common/attention/naive_segmentation.h"

namespace geon::attention {
namespace {

using sensor::PixelFormat;

// The 65,536 colours of one level of red, as an image.
sensor::Image ColorsOfRed(int red, PixelFormat format) {
  sensor::Image image;
  image.width_px = 256;
  image.height_px = 256;
  image.row_stride_bytes = 3 * 256;
  image.format = format;
  image.data.resize(3 * 256 * 256);
  uint8_t* pixel = image.data.data();
  for (int green = 0; green < 256; ++green) {
    for (int blue = 0; blue < 256; ++blue, pixel += 3) {
      pixel[format == PixelFormat::kRgb8 ? 0 : 2] = static_cast<uint8_t>(red);
      pixel[1] = static_cast<uint8_t>(green);
      pixel[format == PixelFormat::kRgb8 ? 2 : 0] = static_cast<uint8_t>(blue);
    }
  }
  return image;
}

ColorClass ClassOf(const PixelClasses& classes, int u, int v) {
  EXPECT_LE(classes.target.At(u, v) + classes.rim.At(u, v) + classes.cannot_tell.At(u, v), 1);
  if (classes.target.At(u, v)) return ColorClass::kTarget;
  if (classes.rim.At(u, v)) return ColorClass::kRim;
  return classes.cannot_tell.At(u, v) ? ColorClass::kCannotTell : ColorClass::kOther;
}

// Every `step`th level of red, every green and blue, every order of channels and set of
// instructions against the rule in double precision.
void ExpectExact(const ColorModel& model, int step) {
  std::vector<PixelClassifier> classifiers;
  for (const SimdLevel level : SimdLevels()) classifiers.emplace_back(model, level);
  for (int red = 0; red < 256; red += step) {
    std::vector<PixelClasses> found;
    for (const PixelFormat format : {PixelFormat::kRgb8, PixelFormat::kBgr8}) {
      const sensor::Image image = ColorsOfRed(red, format);
      for (const auto& classifier : classifiers) found.push_back(classifier.Classify(image, 250));
    }
    int wrong = 0;
    for (int green = 0; green < 256; ++green) {
      for (int blue = 0; blue < 256; ++blue) {
        const Rgb color{static_cast<uint8_t>(red), static_cast<uint8_t>(green),
                        static_cast<uint8_t>(blue)};
        if (ClassOf(found[0], blue, green) != model.Classify(color)) ++wrong;
        if (found[0].lost.At(blue, green) != (std::max({red, green, blue}) >= 250)) ++wrong;
      }
    }
    ASSERT_EQ(wrong, 0) << model.name << ", red " << red;
    for (const PixelClasses& other : found) {
      ASSERT_EQ(other.target, found[0].target) << model.name << ", red " << red;
      ASSERT_EQ(other.rim, found[0].rim) << model.name << ", red " << red;
      ASSERT_EQ(other.cannot_tell, found[0].cannot_tell) << model.name << ", red " << red;
      ASSERT_EQ(other.lost, found[0].lost) << model.name << ", red " << red;
    }
  }
}

TEST(ClassifyPixelsTest, NamedModelsAreExactOnAllColors) {
  for (const std::string& name : NamedColorModels()) ExpectExact(*NamedColorModel(name), 1);
}

TEST(ClassifyPixelsTest, LearnedModelIsExactOnAllColors) {
  std::mt19937 random(1);
  ExpectExact(RandomModel(true, random), 1);
}

TEST(ClassifyPixelsTest, ManyModelsAreExactOnSomeReds) {
  std::mt19937 random(2);
  for (int k = 0; k < 8; ++k) {
    ExpectExact(RandomModel(true, random), 23);
    ExpectExact(RandomModel(false, random), 23);
  }
}

TEST(ClassifyPixelsTest, NumbersBeyondSenseAreExactToo) {
  const auto model = [](const ColorHalfSpace& half_space) {
    return ColorModel{"odd", {{{half_space}}}, {}};
  };
  for (const ColorHalfSpace& half_space : {ColorHalfSpace{0, 0, 0, 0},
                                           {0, 0, 0, -1e-300},
                                           {1e300, -1e300, 1e299, 0},
                                           {1e-310, -1e-310, 1e-311, 0},
                                           {1, 1, 1, 1e300},
                                           {1, -1, 1e-9, 0},
                                           {5e-324, -5e-324, 0, 0},
                                           {0, 1e200, 0, 1e201},
                                           {1.0 / 3, -1.0 / 7, -1.0 / 9, 1.0 / 21}}) {
    ExpectExact(model(half_space), 51);
  }
}

TEST(ClassifyPixelsTest, AnyWidthStrideAndOrderIsClassifiedAsThePixelsAre) {
  std::mt19937 random(3);
  for (const int width : {1, 2, 15, 16, 17, 31, 63, 64, 65, 127, 130, 200}) {
    const ColorModel model = RandomModel(random() % 2 == 0, random);
    for (const PixelFormat format : {PixelFormat::kRgb8, PixelFormat::kBgr8}) {
      const sensor::Image image = RandomImage(width, 9, format, random);
      const auto expected = SegmentNaively(image, model, 8).classes;
      for (const SimdLevel level : SimdLevels()) {
        const PixelClasses found = PixelClassifier(model, level).Classify(image, 250);
        for (int v = 0; v < 9; ++v) {
          for (int u = 0; u < width; ++u) {
            ASSERT_EQ(ClassOf(found, u, v), expected[static_cast<size_t>(v * width + u)])
                << width << ": " << u << ", " << v;
          }
        }
      }
    }
  }
}

TEST(ClassifyPixelsTest, BrokenContractsThrow) {
  EXPECT_THROW(PixelClassifier(ColorModel{}), ContractViolation);
  const PixelClassifier classifier(*NamedColorModel("super-red"));
  EXPECT_THROW(classifier.Classify(ColorsOfRed(0, PixelFormat::kRgb8), 256), ContractViolation);
}

}  // namespace
}  // namespace geon::attention
