#include "attention/classify_pixels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <utility>

#include "attention/classify_row.h"
#include "attention/rgb_image.h"
#include "base/contracts.h"

namespace geon::attention {
namespace {

constexpr int kWordBytes = 3 * 64;

std::vector<SimdLevel> FindSimdLevels() {
  std::vector<SimdLevel> levels = {SimdLevel::kBaseline};
#ifdef GEON_X86_LEVELS
  if (__builtin_cpu_supports("avx2")) levels.push_back(SimdLevel::kAvx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl")) {
    levels.push_back(SimdLevel::kAvx512);
  }
#endif
  return levels;
}

using ClassifyRowFunction = decltype(&ClassifyRowBaseline);

ClassifyRowFunction FunctionOf(SimdLevel level) {
#ifdef GEON_X86_LEVELS
  if (level == SimdLevel::kAvx2) return &ClassifyRowAvx2;
  if (level == SimdLevel::kAvx512) return &ClassifyRowAvx512;
#endif
  Require(level == SimdLevel::kBaseline, "this program has no such SimdLevel");
  return &ClassifyRowBaseline;
}

std::vector<RegionTest> TestsOf(const std::vector<HalfSpaceColor>& regions) {
  std::vector<RegionTest> tests;
  for (const HalfSpaceColor& region : regions) tests.push_back(TestOf(region));
  return tests;
}

// What the rule says of the pixels in doubt.
void SettleDoubt(const ColorModel& model, const RgbImage& image, int v, int word, uint64_t doubt,
                 const RowBits& bits) {
  for (; doubt != 0; doubt &= doubt - 1) {
    const int place = std::countr_zero(doubt);
    const uint64_t pixel = uint64_t{1} << place;
    const ColorClass color_class = model.Classify(image.At(64 * word + place, v));
    const auto set = [&](uint64_t& mask, ColorClass wanted) {
      mask = color_class == wanted ? mask | pixel : mask & ~pixel;
    };
    set(bits.target[word], ColorClass::kTarget);
    set(bits.rim[word], ColorClass::kRim);
  }
}

}  // namespace

const std::vector<SimdLevel>& SimdLevels() {
  static const std::vector<SimdLevel> kLevels = FindSimdLevels();
  return kLevels;
}

PixelClassifier::PixelClassifier(ColorModel model, SimdLevel level)
    : model_(std::move(model)), level_(level) {
  const std::optional<std::string> error = model_.Validate();
  Require(!error, "ColorModel: " + error.value_or(""));
  Require(std::find(SimdLevels().begin(), SimdLevels().end(), level) != SimdLevels().end(),
          "this processor has no such SimdLevel");
  target_ = TestsOf(model_.target);
  rim_ = TestsOf(model_.rim);
}

PixelClasses PixelClassifier::Classify(const sensor::Image& image, int lost_level) const {
  Require(lost_level >= 1 && lost_level <= 255, "lost_level", lost_level, "must be 1 ... 255");
  const RgbImage pixels(image);
  const bool red_is_first = image.format == sensor::PixelFormat::kRgb8;
  const RowTests tests = {target_.data(),      static_cast<int>(target_.size()),
                          rim_.data(),         static_cast<int>(rim_.size()),
                          model_.dark_level_1, model_.clipped_level_1,
                          lost_level};
  const ClassifyRowFunction classify_row = FunctionOf(level_);
  const auto empty = [&image] { return BitMask(image.width_px, image.height_px); };
  PixelClasses classes = {empty(), empty(), empty(), empty()};
  const int words = classes.target.words();
  std::vector<uint64_t> doubt(static_cast<size_t>(words));
  // Without rim, levels and doubt the bits stand as they are, but for those beyond the width.
  const bool plain = rim_.empty() && model_.dark_level_1 == 0 && model_.clipped_level_1 == 256 &&
                     std::none_of(target_.begin(), target_.end(),
                                  [](const RegionTest& region) { return region.doubtful; });
  const int whole_words = image.width_px / 64;
  std::array<uint8_t, kWordBytes> rest{};  // the pixels of the last word, if it is not whole
  for (int v = 0; v < image.height_px; ++v) {
    const uint8_t* row =
        image.data.data() + static_cast<size_t>(v) * static_cast<size_t>(image.row_stride_bytes);
    RowBits bits = {classes.target.row(v), classes.rim.row(v), classes.cannot_tell.row(v),
                    classes.lost.row(v), doubt.data()};
    classify_row(row, red_is_first, whole_words, tests, bits);
    if (whole_words < words) {
      const int done = kWordBytes * whole_words;
      std::memcpy(rest.data(), row + done, static_cast<size_t>(3 * image.width_px - done));
      const RowBits last = {bits.target + whole_words, bits.rim + whole_words,
                            bits.cannot_tell + whole_words, bits.lost + whole_words,
                            bits.doubt + whole_words};
      classify_row(rest.data(), red_is_first, 1, tests, last);
    }
    for (int word = plain ? words - 1 : 0; word < words; ++word) {
      const uint64_t within = classes.target.Within(word);
      SettleDoubt(model_, pixels, v, word, bits.doubt[word] & within, bits);
      bits.target[word] &= within;
      bits.rim[word] &= within & ~bits.target[word];
      bits.cannot_tell[word] &= within & ~bits.target[word] & ~bits.rim[word];
      bits.lost[word] &= within;
    }
  }
  return classes;
}

}  // namespace geon::attention
