#pragma once

#include <vector>

#include "attention/bit_mask.h"
#include "attention/color_model.h"
#include "attention/color_tests.h"
#include "sensor/image.h"

namespace geon::attention {

// Instructions to classify with. The answer is the same.
enum class SimdLevel : uint8_t { kBaseline, kAvx2, kAvx512 };

// Those that this program and this processor have, the fastest last.
const std::vector<SimdLevel>& SimdLevels();

// The classes of an image's pixels (ColorClass; what is in no mask is kOther), and the pixels that
// have lost their colour: a channel at or above a level.
struct PixelClasses {
  BitMask target;
  BitMask rim;
  BitMask cannot_tell;
  BitMask lost;
};

// A colour model made ready to classify images: exactly as ColorModel::Classify says of each pixel,
// some hundred times faster. Making it takes up to a millisecond, so make it once.
//
// Source: thesis 4.1.2. Half-spaces are tested in 16-bit arithmetic on many pixels at once; where
// that leaves a doubt (color_tests.h), the model itself is asked.
class PixelClassifier {
 public:
  // Throws ContractViolation for a model that ColorModel::Validate refuses, and for a level that is
  // none of SimdLevels().
  explicit PixelClassifier(ColorModel model, SimdLevel level = SimdLevels().back());

  // `lost_level`: see PixelClasses::lost, 1 ... 255. Images as RgbImage takes them.
  PixelClasses Classify(const sensor::Image& image, int lost_level) const;

 private:
  ColorModel model_;
  SimdLevel level_;
  std::vector<RegionTest> target_;
  std::vector<RegionTest> rim_;
};

}  // namespace geon::attention
