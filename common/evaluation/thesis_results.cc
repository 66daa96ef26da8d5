#include "evaluation/thesis_results.h"

#include <cmath>

namespace geon::evaluation {
namespace {

struct Row {
  GeonLabel truth;
  int object;
  int position;
  std::array<int, kGeonLabelCount> percent;
};

using enum GeonLabel;

constexpr Row kRows[] = {
    // Table 6.1
    {kTaperedCuboid, 1, 1, {94, 0, 0, 0, 6, 0, 0}},
    {kTaperedCuboid, 1, 2, {98, 1, 0, 0, 1, 0, 0}},
    {kTaperedCuboid, 1, 3, {92, 6, 0, 0, 3, 0, 0}},
    {kTaperedCuboid, 2, 1, {83, 0, 0, 0, 17, 0, 0}},
    {kTaperedCuboid, 2, 2, {93, 4, 0, 0, 3, 0, 0}},
    {kTaperedCuboid, 2, 3, {81, 14, 0, 0, 5, 0, 0}},
    {kTaperedCuboid, 3, 1, {75, 11, 0, 0, 8, 5, 0}},
    {kTaperedCuboid, 3, 2, {84, 4, 0, 0, 11, 1, 0}},
    {kTaperedCuboid, 3, 3, {92, 5, 0, 0, 3, 0, 0}},
    {kTaperedCuboid, 4, 1, {62, 10, 0, 0, 26, 2, 0}},
    {kTaperedCuboid, 4, 2, {62, 10, 0, 0, 16, 12, 0}},
    {kTaperedCuboid, 4, 3, {75, 0, 0, 0, 25, 0, 0}},
    // Table 6.2
    {kTaperedCylinder, 1, 1, {0, 100, 0, 0, 0, 0, 0}},
    {kTaperedCylinder, 1, 2, {1, 68, 0, 0, 2, 23, 6}},
    {kTaperedCylinder, 1, 3, {0, 100, 0, 0, 0, 0, 0}},
    {kTaperedCylinder, 2, 1, {0, 100, 0, 0, 0, 0, 0}},
    {kTaperedCylinder, 2, 2, {0, 78, 0, 0, 0, 4, 18}},
    {kTaperedCylinder, 2, 3, {0, 100, 0, 0, 0, 0, 0}},
    {kTaperedCylinder, 3, 1, {0, 100, 0, 0, 0, 0, 0}},
    {kTaperedCylinder, 3, 2, {0, 90, 0, 0, 0, 6, 4}},
    {kTaperedCylinder, 3, 3, {0, 100, 0, 0, 0, 0, 0}},
    {kTaperedCylinder, 4, 1, {0, 100, 0, 0, 0, 0, 0}},
    {kTaperedCylinder, 4, 2, {0, 90, 0, 0, 0, 10, 0}},
    {kTaperedCylinder, 4, 3, {0, 100, 0, 0, 0, 0, 0}},
    // Table 6.3
    {kBentCuboid, 1, 1, {0, 0, 98, 2, 0, 0, 0}},
    {kBentCuboid, 1, 2, {0, 16, 76, 2, 0, 6, 0}},
    {kBentCuboid, 1, 3, {0, 1, 87, 12, 0, 0, 0}},
    {kBentCuboid, 2, 1, {0, 0, 83, 17, 0, 0, 0}},
    {kBentCuboid, 2, 2, {0, 15, 75, 4, 0, 6, 0}},
    {kBentCuboid, 2, 3, {0, 0, 86, 14, 0, 0, 0}},
    {kBentCuboid, 3, 1, {0, 0, 85, 15, 0, 0, 0}},
    {kBentCuboid, 3, 2, {0, 21, 73, 0, 0, 6, 0}},
    {kBentCuboid, 3, 3, {0, 3, 86, 11, 0, 0, 0}},
    {kBentCuboid, 4, 1, {0, 0, 83, 17, 0, 0, 0}},
    {kBentCuboid, 4, 2, {15, 18, 61, 0, 0, 6, 0}},
    {kBentCuboid, 4, 3, {4, 10, 83, 3, 0, 0, 0}},
    // Table 6.4
    {kBentCylinder, 1, 1, {0, 0, 27, 73, 0, 0, 0}},
    {kBentCylinder, 1, 2, {0, 0, 0, 83, 0, 0, 17}},
    {kBentCylinder, 2, 1, {0, 0, 40, 60, 0, 0, 0}},
    {kBentCylinder, 3, 1, {0, 0, 43, 57, 0, 0, 0}},
    {kBentCylinder, 4, 1, {0, 0, 52, 48, 0, 0, 0}},
    // Table 6.5
    {kCuboid, 1, 1, {0, 0, 0, 0, 83, 17, 0}},
    {kCuboid, 2, 1, {0, 0, 0, 0, 89, 11, 0}},
    {kCuboid, 2, 2, {0, 0, 0, 0, 67, 33, 0}},
    {kCuboid, 3, 1, {0, 0, 0, 0, 88, 12, 0}},
    {kCuboid, 3, 2, {0, 0, 0, 0, 86, 14, 0}},
    {kCuboid, 4, 1, {0, 0, 0, 0, 94, 6, 0}},
    {kCuboid, 4, 2, {0, 0, 0, 0, 94, 6, 0}},
    // Table 6.6
    {kCylinder, 1, 1, {0, 0, 0, 0, 0, 100, 0}},
    {kCylinder, 1, 2, {0, 0, 0, 0, 0, 100, 0}},
    {kCylinder, 2, 1, {0, 0, 0, 0, 0, 97, 3}},
    {kCylinder, 2, 2, {0, 0, 0, 0, 0, 100, 0}},
    {kCylinder, 3, 1, {0, 0, 0, 0, 0, 100, 0}},
    {kCylinder, 3, 2, {0, 0, 0, 0, 0, 100, 0}},
    {kCylinder, 4, 1, {0, 0, 0, 0, 0, 100, 0}},
    {kCylinder, 4, 2, {0, 0, 0, 0, 0, 100, 0}},
    // Table 6.7
    {kEllipsoid, 1, 1, {0, 0, 0, 0, 0, 0, 100}},
    {kEllipsoid, 2, 1, {0, 0, 0, 0, 0, 0, 100}},
    {kEllipsoid, 3, 1, {0, 6, 0, 0, 0, 15, 78}},
    {kEllipsoid, 4, 1, {0, 53, 0, 3, 0, 25, 19}},
};

// Tables 6.8-6.10, rows and columns by GeonLabel.
struct BenchTable {
  double range_m;
  std::array<std::array<int, kGeonLabelCount>, kGeonLabelCount> percent;
};
constexpr std::array<BenchTable, 3> kBenchTables = {{
    {1.0,
     {{{90, 0, 0, 10, 0, 0, 0},
       {0, 80, 0, 0, 10, 0, 10},
       {0, 0, 100, 0, 0, 0, 0},
       {27, 0, 0, 64, 9, 0, 0},
       {0, 18, 0, 0, 82, 0, 0},
       {0, 0, 0, 0, 0, 83, 17},
       {0, 0, 8, 0, 0, 17, 75}}}},
    {1.3,
     {{{80, 10, 0, 10, 0, 0, 0},
       {0, 80, 0, 0, 20, 0, 0},
       {0, 0, 100, 0, 0, 0, 0},
       {9, 0, 0, 73, 18, 0, 0},
       {0, 9, 0, 0, 82, 9, 0},
       {0, 0, 0, 0, 0, 75, 25},
       {0, 0, 8, 0, 8, 17, 67}}}},
    {1.6,
     {{{50, 30, 0, 10, 0, 10, 0},
       {0, 60, 0, 0, 10, 0, 30},
       {0, 10, 80, 0, 0, 0, 10},
       {9, 0, 0, 55, 36, 0, 0},
       {0, 9, 0, 0, 73, 9, 9},
       {0, 0, 0, 0, 0, 58, 42},
       {0, 0, 0, 0, 8, 25, 67}}}},
}};

}  // namespace

std::optional<std::array<int, kGeonLabelCount>> ThesisRow(const Subject& subject) {
  for (const Row& row : kRows) {
    if (row.truth == subject.truth && std::to_string(row.object) == subject.object &&
        row.position == subject.position) {
      return row.percent;
    }
  }
  return std::nullopt;
}

std::optional<std::array<double, kGeonLabelCount>> ThesisMeanRow(
    std::span<const Subject> subjects) {
  if (subjects.empty()) return std::nullopt;
  std::array<double, kGeonLabelCount> mean{};
  for (const Subject& subject : subjects) {
    const auto row = ThesisRow(subject);
    if (!row) return std::nullopt;
    for (size_t k = 0; k < kThesisColumns.size(); ++k) {
      mean[static_cast<size_t>(kThesisColumns[k])] +=
          static_cast<double>((*row)[k]) / static_cast<double>(subjects.size());
    }
  }
  return mean;
}

std::optional<std::array<int, kGeonLabelCount>> ThesisBenchRow(double range_m, GeonLabel truth) {
  constexpr double kSameRange_m = 0.005;
  for (const BenchTable& table : kBenchTables) {
    if (std::abs(table.range_m - range_m) < kSameRange_m) {
      return table.percent[static_cast<size_t>(truth)];
    }
  }
  return std::nullopt;
}

}  // namespace geon::evaluation
