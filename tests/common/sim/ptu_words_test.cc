#include "sim/ptu_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geon::sim {
namespace {

using ::testing::ElementsAre;

TEST(PtuWords, LettersThenNumbersInAnyCase) {
  const auto move = ParsePtuWord("pp-1500");
  ASSERT_TRUE(move.has_value());
  EXPECT_EQ(move->letters, "PP");
  EXPECT_THAT(move->numbers, ElementsAre(-1500));
  const auto monitor = ParsePtuWord("M1,-2,+3,4");
  ASSERT_TRUE(monitor.has_value());
  EXPECT_THAT(monitor->numbers, ElementsAre(1, -2, 3, 4));
  EXPECT_FALSE(ParsePtuWord("V")->has_number());
  EXPECT_EQ(ParsePtuWord("_0")->letters, "_");
  EXPECT_EQ(ParsePtuWord("?")->letters, "?");
}

TEST(PtuWords, WhatIsNoneIsNone) {
  for (const char* word :
       {"", "12", "PP12x", "PP1.5", "PP1,", "PP,1", "P\xff", "PP--3", "PP99999999999"}) {
    EXPECT_FALSE(ParsePtuWord(word).has_value()) << word;
  }
}

}  // namespace
}  // namespace geon::sim
