#include "procs/geon/experiment_json.h"

#include <algorithm>
#include <string>

namespace geon::cli {
namespace {

using nlohmann::json;

bool SameSubject(const evaluation::Subject& a, const evaluation::Subject& b) {
  return a.truth == b.truth && a.object == b.object && a.position == b.position;
}

}  // namespace

json OptionalJson(const std::optional<double>& value) { return value ? json(*value) : json(); }

std::optional<double> ParseOptional(const json& value) {
  if (value.is_null()) return std::nullopt;
  return value.get<double>();
}

json LabelJson(const std::optional<GeonLabel>& label) {
  return label ? json(ToString(*label)) : json();
}

GeonLabel ParseLabel(const json& value) {
  return GeonLabelFromString(value.get<std::string>()).value();
}

std::optional<GeonLabel> ParseOptionalLabel(const json& value) {
  if (value.is_null()) return std::nullopt;
  return ParseLabel(value);
}

json CellJson(const evaluation::ConfusionRow& row, int n, const json& range_m) {
  json counts;
  for (size_t k = 0; k < row.counts.size(); ++k) {
    counts[std::string(kGeonLabelNames[k])] = row.counts[k];
  }
  return {{"truth", ToString(row.subject.truth)},
          {"object", row.subject.object},
          {"position", row.subject.position},
          {"range_m", range_m},
          {"n", n},
          {"counts", counts},
          {"undecided", row.undecided}};
}

json AnswerCells(const std::vector<Answer>& answers) {
  struct Cell {
    evaluation::ConfusionRow row;
    std::optional<double> range_m;
    int n = 0;
  };
  std::vector<Cell> cells;
  for (const Answer& answer : answers) {
    auto cell = std::find_if(cells.begin(), cells.end(), [&](const Cell& each) {
      return SameSubject(each.row.subject, answer.subject) && each.range_m == answer.range_m;
    });
    if (cell == cells.end()) {
      cell = cells.insert(cell, {{answer.subject, {}, 0}, answer.range_m, 0});
    }
    ++cell->n;
    if (answer.label) ++cell->row.counts[static_cast<size_t>(*answer.label)];
    if (!answer.decided) ++cell->row.undecided;
  }
  json list = json::array();
  for (const Cell& cell : cells)
    list.push_back(CellJson(cell.row, cell.n, OptionalJson(cell.range_m)));
  return list;
}

}  // namespace geon::cli
