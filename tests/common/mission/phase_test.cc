#include "mission/phase.h"

#include <gtest/gtest.h>

#include <set>

namespace geon::mission {
namespace {

TEST(PhaseTest, EveryPhaseHasANameOfItsOwn) {
  std::set<std::string_view> names;
  for (const Phase phase : {Phase::kWait, Phase::kSearch, Phase::kApproach, Phase::kCentre,
                            Phase::kBackOff, Phase::kScan, Phase::kDone}) {
    EXPECT_FALSE(ToString(phase).empty());
    names.insert(ToString(phase));
  }
  EXPECT_EQ(names.size(), 7u);
}

}  // namespace
}  // namespace geon::mission
