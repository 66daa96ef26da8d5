#include "rangefinder/stripe_runs.h"

#include <gtest/gtest.h>

#include <random>

#include "base/contracts.h"

namespace geon::rangefinder {
namespace {

using sensor::Laser;

sensor::Image RandomImage(int width_px, int height_px, unsigned seed) {
  sensor::Image image;
  image.width_px = width_px;
  image.height_px = height_px;
  image.row_stride_bytes = width_px + 5;
  image.data.resize(static_cast<size_t>(image.row_stride_bytes * height_px));
  std::mt19937 random(seed);
  for (uint8_t& level : image.data) level = static_cast<uint8_t>(random() % 256);
  return image;
}

// Pixel by pixel: what the sweep must find.
std::vector<Run> PlainRuns(const sensor::Image& image, Laser laser, int level_1) {
  const LineView view(image, laser);
  std::vector<Run> runs;
  for (int line = 0; line < view.lines; ++line) {
    for (int i = 0; i < view.length; ++i) {
      if (view.At(line, i) < level_1) continue;
      if (!runs.empty() && runs.back().line == line && i - runs.back().last <= 2) {
        runs.back().last = i;
      } else {
        runs.push_back({line, i, i});
      }
    }
  }
  return runs;
}

TEST(StripeRunsTest, SweepFindsWhatPixelByPixelFinds) {
  for (const int width_px : {1, 63, 64, 65, 200, 640}) {
    const sensor::Image image = RandomImage(width_px, 70, static_cast<unsigned>(width_px));
    for (const Laser laser : {Laser::kHorizontal, Laser::kVertical}) {
      for (const int level_1 : {1, 100, 230, 255}) {
        const auto runs = FindRuns(image, laser, static_cast<uint8_t>(level_1));
        const auto plain = PlainRuns(image, laser, level_1);
        ASSERT_EQ(runs.size(), plain.size()) << width_px << " " << level_1;
        for (size_t k = 0; k < runs.size(); ++k) {
          ASSERT_EQ(runs[k].line, plain[k].line);
          ASSERT_EQ(runs[k].first, plain[k].first);
          ASSERT_EQ(runs[k].last, plain[k].last);
        }
      }
    }
  }
}

TEST(StripeRunsTest, LevelZeroIsRefused) {
  EXPECT_THROW(FindRuns(RandomImage(8, 8, 1), Laser::kVertical, 0), ContractViolation);
}

}  // namespace
}  // namespace geon::rangefinder
