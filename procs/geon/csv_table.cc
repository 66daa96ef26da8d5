#include "procs/geon/csv_table.h"

#include <algorithm>

namespace geon::cli {

std::string CsvTable::At(size_t row, const std::string& column) const {
  const auto place =
      static_cast<size_t>(std::find(heading.begin(), heading.end(), column) - heading.begin());
  return place < rows[row].size() && place < heading.size() ? rows[row][place] : std::string();
}

CsvTable ParseCsv(const std::string& text) {
  std::vector<std::vector<std::string>> lines;
  std::vector<int> numbers;  // of the lines
  std::vector<std::string> line;
  std::string field;
  bool quoted = false;
  int number = 1, next = 1;
  const auto end_line = [&] {
    if (line.empty() && field.empty()) return;  // a blank line
    line.push_back(std::move(field));
    field.clear();
    lines.push_back(std::move(line));
    numbers.push_back(number);
    line.clear();
  };
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') ++next;
    if (c == '"') {
      if (quoted && i + 1 < text.size() && text[i + 1] == '"') {
        field += '"';
        ++i;
      } else {
        quoted = !quoted;
      }
    } else if (quoted || (c != ',' && c != '\n' && c != '\r')) {
      field += c;
    } else if (c == ',') {
      line.push_back(std::move(field));
      field.clear();
    } else if (c == '\n') {
      end_line();
      number = next;
    }
  }
  end_line();
  CsvTable table;
  if (lines.empty()) return table;
  table.heading = std::move(lines.front());
  table.rows.assign(lines.begin() + 1, lines.end());
  table.lines.assign(numbers.begin() + 1, numbers.end());
  return table;
}

}  // namespace geon::cli
