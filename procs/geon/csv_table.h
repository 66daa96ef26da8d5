#pragma once

#include <string>
#include <vector>

namespace geon::cli {

// A table with a heading, as spreadsheets write it (RFC 4180): fields in double quotes may hold
// commas, line ends and, doubled, quotes.
struct CsvTable {
  std::vector<std::string> heading;
  std::vector<std::vector<std::string>> rows;
  std::vector<int> lines;  // of the text, from 1, on which each row begins
  // Empty when the table has no such column or the row ends before it.
  std::string At(size_t row, const std::string& column) const;
};

CsvTable ParseCsv(const std::string& text);

}  // namespace geon::cli
