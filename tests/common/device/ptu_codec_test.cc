#include "device/ptu_codec.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace geon::device {
namespace {

using PtuKind = PtuLine::Kind;

std::vector<PtuLine> PtuLines(PtuReader* reader, const std::string& bytes) {
  reader->Push(bytes);
  std::vector<PtuLine> lines;
  while (const auto line = reader->Next()) lines.push_back(*line);
  return lines;
}

TEST(PtuCodecTest, CommandsAreLettersNumberAndADelimiter) {
  EXPECT_EQ(EncodePtuCommand("PP"), "PP ");
  EXPECT_EQ(EncodePtuCommand("PP", -500), "PP-500 ");
  EXPECT_EQ(EncodePtuCommand("TS", 1000), "TS1000 ");
}

TEST(PtuCodecTest, SortsTerseVerboseEchoedAndRefusedAnswers) {
  PtuReader reader;
  const auto lines = PtuLines(&reader,
                              "* 123\r\n"
                              "PP * Current Pan position is 0\r\n"
                              "! Maximum allowable Pan position is 3090\r\n"
                              "\r\n\r\n*\r\n"
                              "### PAN-TILT CONTROLLER ***\r\n"
                              "what\r\n");
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(lines[0].kind, PtuKind::kDone);
  EXPECT_EQ(lines[0].text, "123");
  EXPECT_EQ(lines[0].echo, "");
  EXPECT_EQ(lines[1].kind, PtuKind::kDone);
  EXPECT_EQ(lines[1].echo, "PP");
  EXPECT_EQ(lines[1].text, "Current Pan position is 0");
  EXPECT_EQ(lines[2].kind, PtuKind::kRefused);
  EXPECT_EQ(lines[2].text, "Maximum allowable Pan position is 3090");
  EXPECT_EQ(lines[3].kind, PtuKind::kDone);
  EXPECT_EQ(lines[3].text, "");
  EXPECT_EQ(lines[4].kind, PtuKind::kBanner);
  EXPECT_EQ(lines[5].kind, PtuKind::kUnknown);
}

TEST(PtuCodecTest, TakesLimitMarksOutWhereverTheyAre) {
  for (size_t at = 0; at <= 5; ++at) {
    PtuReader reader;
    std::string bytes = "* 123\r\n";
    bytes.insert(at, "!T");
    const auto lines = PtuLines(&reader, bytes);
    ASSERT_EQ(lines.size(), 1u) << at;
    EXPECT_EQ(lines[0].kind, PtuKind::kDone) << at;
    EXPECT_EQ(lines[0].text, "123") << at;
    EXPECT_TRUE(reader.TakeTiltLimit()) << at;
    EXPECT_FALSE(reader.TakeTiltLimit()) << at;
    EXPECT_FALSE(reader.TakePanLimit()) << at;
  }
}

TEST(PtuCodecTest, AMarkIsKnownBeforeAnyLineEnd) {
  PtuReader reader;
  EXPECT_TRUE(PtuLines(&reader, "!").empty());
  EXPECT_FALSE(reader.TakePanLimit());
  EXPECT_TRUE(PtuLines(&reader, "P").empty());
  EXPECT_TRUE(reader.TakePanLimit());
}

TEST(PtuCodecTest, ResetAnswersWithMarksAndAStarThatMayLackItsLineEnd) {
  PtuReader reader;
  EXPECT_TRUE(PtuLines(&reader, "!T!T!P!P*").empty());
  const auto line = reader.TakeUnfinished();
  ASSERT_TRUE(line.has_value());
  EXPECT_EQ(line->kind, PtuKind::kDone);
  EXPECT_EQ(line->text, "");
  EXPECT_TRUE(reader.TakePanLimit());
  EXPECT_TRUE(reader.TakeTiltLimit());
  // The line end that some firmware adds later is not a second answer.
  EXPECT_TRUE(PtuLines(&reader, "\r\n").empty());
  EXPECT_FALSE(reader.TakeUnfinished().has_value());
}

TEST(PtuCodecTest, OnlyAWholeNumberIsANumber) {
  EXPECT_EQ(ParsePtuCount("-3090"), -3090);
  EXPECT_EQ(ParsePtuNumber("185.1428"), 185.1428);
  for (const std::string text :
       {"", "Current Pan position is 0", "12x", "\xff 12", "99999999999", "12 13", "1.5"}) {
    EXPECT_FALSE(ParsePtuCount(text).has_value()) << text;
  }
  EXPECT_FALSE(ParsePtuNumber("nan").has_value());
  EXPECT_FALSE(ParsePtuNumber("inf").has_value());
}

TEST(PtuCodecTest, AFloodWithoutLineEndDoesNotGrowForever) {
  PtuReader reader;
  const auto lines = PtuLines(&reader, std::string(10'000, 'x'));
  EXPECT_GE(lines.size(), 40u);
  EXPECT_LE(reader.TakeUnfinished()->text.size(), 200u);
}

TEST(PtuCodecTest, AnyBytesAreFollowedByStep) {
  std::mt19937 random(1);
  for (int i = 0; i < 10'000; ++i) {
    PtuReader reader;
    std::string noise(random() % 40, '\0');
    for (char& byte : noise) byte = static_cast<char>(random());
    PtuLines(&reader, noise + "\r\n");
    const auto lines = PtuLines(&reader, "* 7\r\n");
    ASSERT_EQ(lines.size(), 1u);
    ASSERT_EQ(lines[0].text, "7");
  }
}

}  // namespace
}  // namespace geon::device
