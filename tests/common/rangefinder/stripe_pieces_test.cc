#include "rangefinder/stripe_pieces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geon::rangefinder {
namespace {

using testing::ElementsAre;

PeakCandidate PeakAt(int line, double position_px) {
  PeakCandidate candidate;
  candidate.line = line;
  candidate.fit.position_px = position_px;
  candidate.fit.peak_1 = 100.0;
  candidate.fit.width_px = 2.0;
  return candidate;
}

TEST(StripePiecesTest, NeighborsWithinAStepFormOnePiece) {
  const auto pieces =
      LinkPieces({PeakAt(0, 10), PeakAt(1, 12), PeakAt(2, 14.5), PeakAt(3, 13)}, {3, 2, 2});
  EXPECT_THAT(pieces, ElementsAre(ElementsAre(0, 1, 2, 3)));
}

TEST(StripePiecesTest, ALeapBreaksThePiece) {
  const auto pieces =
      LinkPieces({PeakAt(0, 10), PeakAt(1, 11), PeakAt(2, 20), PeakAt(3, 21)}, {3, 2, 2});
  EXPECT_THAT(pieces, ElementsAre(ElementsAre(0, 1), ElementsAre(2, 3)));
}

TEST(StripePiecesTest, SmallGapsAreBridgedAndLargeOnesNot) {
  const std::vector<PeakCandidate> small = {PeakAt(0, 10), PeakAt(1, 10), PeakAt(4, 11),
                                            PeakAt(5, 11)};
  EXPECT_THAT(LinkPieces(small, {3, 2, 2}), ElementsAre(ElementsAre(0, 1, 2, 3)));
  EXPECT_THAT(LinkPieces(small, {3, 1, 2}), ElementsAre(ElementsAre(0, 1), ElementsAre(2, 3)));
}

TEST(StripePiecesTest, ParallelPiecesStaySeparate) {
  const auto pieces = LinkPieces(
      {PeakAt(0, 10), PeakAt(0, 13), PeakAt(1, 10), PeakAt(1, 13), PeakAt(2, 13), PeakAt(2, 10)},
      {3, 2, 2});
  EXPECT_THAT(pieces, ElementsAre(ElementsAre(0, 2, 5), ElementsAre(1, 3, 4)));
}

TEST(StripePiecesTest, ShortPiecesAndGlareAreLeftOut) {
  std::vector<PeakCandidate> candidates = {PeakAt(0, 10), PeakAt(1, 10), PeakAt(2, 10),
                                           PeakAt(8, 90), PeakAt(9, 90)};
  EXPECT_THAT(LinkPieces(candidates, {3, 2, 3}), ElementsAre(ElementsAre(0, 1, 2)));
  for (PeakCandidate& candidate : candidates) candidate.too_wide = true;
  EXPECT_TRUE(LinkPieces(candidates, {3, 2, 1}).empty());
}

}  // namespace
}  // namespace geon::rangefinder
