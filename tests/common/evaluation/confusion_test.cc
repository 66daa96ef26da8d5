#include "evaluation/confusion.h"

#include <gtest/gtest.h>

#include "base/angles.h"

namespace geon::evaluation {
namespace {

ShapeTrial Trial(int t, int subject, GeonLabel answer, int elevation_deg, bool decided = true) {
  return {t, subject, {RadiansFromDegrees(elevation_deg), 0.1 * t}, answer, 0.5, decided};
}

const std::vector<Subject> kSubjects = {
    {GeonLabel::kCuboid, "1", 1}, {GeonLabel::kCylinder, "1", 2}, {GeonLabel::kEllipsoid, "1", 1}};
const std::vector<ShapeTrial> kTrials = {
    Trial(0, 0, GeonLabel::kCuboid, 35), Trial(1, 0, GeonLabel::kCylinder, 35),
    Trial(2, 0, GeonLabel::kCuboid, 45, false), Trial(3, 1, GeonLabel::kCylinder, 45)};

TEST(Confusion, CountsAnswersOfEverySubjectThatWasTried) {
  const std::vector<ConfusionRow> rows = CountAnswers(kSubjects, kTrials);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].counts, (std::array{2, 1, 0, 0, 0, 0, 0}));
  EXPECT_EQ(rows[0].undecided, 1);
  EXPECT_EQ(rows[0].rate().right, 2);
  EXPECT_EQ(rows[1].subject.position, 2);
}

TEST(Confusion, MeanOfRowsCountsEveryRowAlike) {
  const std::vector<ConfusionRow> rows = CountAnswers(kSubjects, kTrials);
  EXPECT_NEAR(MeanOfRows(rows), (2.0 / 3.0 + 1.0) / 2.0, 1e-12);
  EXPECT_NEAR(OverallRate(rows).value_1(), 0.75, 1e-12);
  EXPECT_EQ(RatesByClass(rows)[static_cast<size_t>(GeonLabel::kCuboid)].n, 3);
  EXPECT_EQ(RatesByClass(rows)[static_cast<size_t>(GeonLabel::kEllipsoid)].n, 0);
  EXPECT_EQ(MeanOfRows({}), 0.0);
}

TEST(Confusion, TheWorstIsTheFirstOfTheLowestRate) {
  const std::vector<ConfusionRow> rows = CountAnswers(kSubjects, kTrials);
  EXPECT_EQ(WorstClass(rows), GeonLabel::kCuboid);
  EXPECT_EQ(WorstRow(rows)->subject.object, "1");
  EXPECT_EQ(WorstRow(rows)->subject.truth, GeonLabel::kCuboid);
  const std::vector<CellRate> cells = RatesByCell(kSubjects, kTrials);
  EXPECT_EQ(WorstCell(cells)->rate.right, 0);
  EXPECT_EQ(WorstCell(std::vector{cells[0], cells[2]})->cell.azimuth_rad,
            cells[0].cell.azimuth_rad);
  EXPECT_FALSE(WorstClass({}).has_value());
  EXPECT_FALSE(WorstRow({}).has_value());
  EXPECT_FALSE(WorstCell({}).has_value());
}

TEST(Confusion, RatesByViewComeInOrder) {
  const std::vector<CellRate> cells = RatesByCell(kSubjects, kTrials);
  ASSERT_EQ(cells.size(), 4U);
  EXPECT_EQ(cells[1].rate.right, 0);
  const std::vector<CellRate> elevations = RatesByElevation(cells);
  ASSERT_EQ(elevations.size(), 2U);
  EXPECT_NEAR(elevations[0].rate.value_1(), 0.5, 1e-12);
  EXPECT_NEAR(elevations[1].rate.value_1(), 1.0, 1e-12);
}

}  // namespace
}  // namespace geon::evaluation
