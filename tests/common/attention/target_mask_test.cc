#include "attention/target_mask.h"

#include <gtest/gtest.h>

#include "base/contracts.h"

namespace geon::attention {
namespace {

TargetSighting SightingOf(int width_px, int height_px, const sensor::PixelBox& box) {
  TargetSighting seen;
  seen.width_px = width_px;
  seen.height_px = height_px;
  seen.mask.assign(static_cast<size_t>(width_px * height_px), 0);
  seen.target = Blob{box, 0, {}};
  return seen;
}

TEST(MakeTargetMask, GivesTheBoxAsRuns) {
  TargetSighting seen = SightingOf(6, 4, {1, 1, 4, 2});
  for (const size_t at : {6 + 2, 6 + 3, 12 + 1, 12 + 2}) seen.mask[at] = 255;
  const sensor::TargetMask mask = MakeTargetMask(seen);
  EXPECT_EQ(mask.box, (sensor::PixelBox{1, 1, 4, 2}));
  EXPECT_EQ(mask.runs_px, (std::vector<int16_t>{1, 2, 1, 2, 2}));
}

TEST(MakeTargetMask, BeginsWithBackgroundEvenWhereThereIsNone) {
  TargetSighting seen = SightingOf(2, 1, {0, 0, 2, 1});
  seen.mask = {255, 0};
  EXPECT_EQ(MakeTargetMask(seen).runs_px, (std::vector<int16_t>{0, 1, 1}));
}

TEST(MakeTargetMask, SplitsRunsThatAreTooLong) {
  TargetSighting seen = SightingOf(400, 100, {0, 0, 400, 100});
  seen.mask.assign(seen.mask.size(), 255);
  EXPECT_EQ(MakeTargetMask(seen).runs_px, (std::vector<int16_t>{0, 32767, 0, 40000 - 32767}));
}

TEST(MakeTargetMask, NeedsATarget) { EXPECT_THROW(MakeTargetMask({}), ContractViolation); }

}  // namespace
}  // namespace geon::attention
