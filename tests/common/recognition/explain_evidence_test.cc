#include "recognition/explain_evidence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geon::recognition {
namespace {

TEST(ExplainEvidence, SaysWhatSpeaksForTheVerdict) {
  sensor::GeonVerdict verdict;
  for (double length_m : {0.100, 0.110, 0.132}) {
    sensor::ProfileEvidence profile;
    profile.segments = 1;
    profile.curves = 1;
    profile.length_m = length_m;
    verdict.profiles.push_back(profile);
  }
  verdict.bending.concave_edge = true;
  verdict.bending.concave_edge_m = 0.012;
  verdict.posterior[static_cast<size_t>(GeonLabel::kTaperedCylinder)] = 0.9;
  verdict.posterior[static_cast<size_t>(GeonLabel::kCylinder)] = 0.1;
  EXPECT_THAT(ExplainEvidence(verdict),
              testing::ElementsAre(
                  "bending: end points lie 12 mm inside a straight edge.",
                  "tapering: 3 horizontal lengths 100, 110, 132 mm (+10 %, +20 %); no vertical "
                  "stripe on the target.",
                  "surface: curves in 3 of 3 profiles, corners in 0.",
                  "weighed together: tapered cylinder 90 %, cylinder 10 %."));
}

}  // namespace
}  // namespace geon::recognition
