#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "rangefinder/look_up_table.h"

namespace geon::rangefinder {
namespace {

using testing::HasSubstr;

LookUpTable Table() {
  LookUpTable table;
  table.laser = sensor::Laser::kVertical;
  table.date = "2026-01-31";
  table.width_px = 640;
  table.height_px = 20;
  table.frames = 10;
  table.first_distance_m = 0.65;
  table.step_m = 0.005;
  table.distances = 30;
  for (int line = 0; line < 20; ++line) {
    for (int k = 0; k < 30; ++k) {
      table.position_px.push_back(200.0 / (0.65 + 0.005 * k) + 0.3 * line);
    }
  }
  table.position_px[77] = std::numeric_limits<double>::quiet_NaN();
  return table;
}

TEST(LookUpTableFileTest, TableSurvivesTheRoundTripToAThousandthOfAPixel) {
  const LookUpTable table = Table();
  const auto read = ParseLookUpTable(SerializeLookUpTable(table));
  ASSERT_TRUE(read.ok()) << read.message();
  EXPECT_EQ(read->laser, table.laser);
  EXPECT_EQ(read->date, table.date);
  EXPECT_EQ(read->width_px, 640);
  EXPECT_EQ(read->lines(), 20);
  EXPECT_EQ(read->frames, 10);
  EXPECT_EQ(read->first_distance_m, 0.65);
  EXPECT_EQ(read->step_m, 0.005);
  ASSERT_EQ(read->position_px.size(), table.position_px.size());
  for (size_t i = 0; i < table.position_px.size(); ++i) {
    if (i == 77) {
      EXPECT_TRUE(std::isnan(read->position_px[i]));
    } else {
      EXPECT_NEAR(read->position_px[i], table.position_px[i], 0.001);
    }
  }
  EXPECT_EQ(SerializeLookUpTable(*read), SerializeLookUpTable(table)) << "stable once rounded";
}

TEST(LookUpTableFileTest, EveryTruncationIsRefused) {
  const std::string bytes = SerializeLookUpTable(Table());
  for (size_t length = 0; length < bytes.size(); ++length) {
    ASSERT_FALSE(ParseLookUpTable(bytes.substr(0, length)).ok()) << length;
  }
  EXPECT_FALSE(ParseLookUpTable(bytes + "x").ok());
}

TEST(LookUpTableFileTest, DamagedDataIsRefused) {
  std::string bytes = SerializeLookUpTable(Table());
  bytes[bytes.size() - 100] = static_cast<char>(bytes[bytes.size() - 100] ^ 1);
  EXPECT_THAT(ParseLookUpTable(bytes).message(), HasSubstr("damaged"));
}

TEST(LookUpTableFileTest, HeaderErrorsSayWhatIsExpected) {
  const auto error = [](const std::string& from, const std::string& to) {
    std::string bytes = SerializeLookUpTable(Table());
    bytes.replace(bytes.find(from), from.size(), to);
    return ParseLookUpTable(bytes).message();
  };
  EXPECT_THAT(error("geon.lut.v1", "geon.lut.v2"), HasSubstr("first line must be geon.lut.v1"));
  EXPECT_THAT(error("laser vertical", "laser diagonal"), HasSubstr("horizontal or vertical"));
  EXPECT_THAT(error("width_px 640", "width_px 64O"), HasSubstr("width_px must be a number"));
  EXPECT_THAT(error("height_px 20", "height_px 0"), HasSubstr("height_px must be a number"));
  EXPECT_THAT(error("step_m 0.005", "step_m nan"), HasSubstr("step_m must be a number"));
  EXPECT_THAT(error("frames", "pictures"), HasSubstr("expected \"frames VALUE\""));
  EXPECT_THAT(error("distances 30", "distances 31"), HasSubstr("bytes of data, expected"));
}

TEST(LookUpTableFileTest, TableThatIsNotMonotoneIsRefused) {
  LookUpTable table = Table();
  table.position_px[33] = table.position_px[31];
  EXPECT_THAT(ParseLookUpTable(SerializeLookUpTable(table)).message(),
              HasSubstr("line 1 is not monotone at distance 3"));
}

}  // namespace
}  // namespace geon::rangefinder
