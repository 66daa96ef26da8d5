#include "procs/geon/csv_table.h"

#include <gtest/gtest.h>

namespace geon::cli {
namespace {

TEST(ParseCsv, FindsFieldsByColumn) {
  const CsvTable table = ParseCsv("name,label\r\na,cuboid\n\nb,cylinder");
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.At(1, "name"), "b");
  EXPECT_EQ(table.At(0, "label"), "cuboid");
  EXPECT_EQ(table.At(0, "weight"), "");
}

TEST(ParseCsv, RowsKnowTheirLines) {
  const CsvTable table = ParseCsv("name,why\n\na,b\nc,\"d\nd\"\r\n\ne,f\n");
  EXPECT_EQ(table.lines, (std::vector<int>{3, 4, 7}));
}

TEST(ParseCsv, QuotedFieldsHoldCommasQuotesAndLines) {
  const CsvTable table = ParseCsv("name,why,label\na,\"thin, \"\"open\"\"\nabove\",cylinder\n");
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.At(0, "why"), "thin, \"open\"\nabove");
  EXPECT_EQ(table.At(0, "label"), "cylinder");
}

TEST(ParseCsv, ShortRowsAndNoTextAreNoTrouble) {
  EXPECT_EQ(ParseCsv("a,b\n1\n").At(0, "b"), "");
  EXPECT_TRUE(ParseCsv("").rows.empty());
}

}  // namespace
}  // namespace geon::cli
