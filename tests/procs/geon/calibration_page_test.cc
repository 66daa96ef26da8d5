#include "procs/geon/calibration_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geon::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

geometry::CalibratedRig Record(bool weak) {
  geometry::CalibratedRig record;
  record.date = "2026-11-22";
  record.stops = 5;
  record.views = 75;
  for (const char* what : {"corners in the B/W pictures", "corners in the colour pictures",
                           "points of horizontal stripes", "points of vertical stripes"}) {
    record.residuals.push_back({what, 1000, 0.031, 2});
  }
  record.range_sigmas = {{"horizontal", 1.0, 0.00012}, {"vertical", 1.0, 0.00018}};
  record.estimates = {{"B/W camera", "distortion k2", "", 0.1, 0.8, weak},
                      {"B/W camera", "focal length", "px", 12.0, 0.4, false}};
  return record;
}

TEST(CalibrationPage, TellsTheWorstLaserAtOneMetreFirst) {
  calibration::RigObservations observations;
  observations.views.push_back({0, 0, 0, {{10, 20}}, {{30, 40}}, {{50, 60}}, {{70, 80}}});
  const std::string page = CalibrationPage(Record(true), {}, observations);
  EXPECT_THAT(page, HasSubstr("Range known to 0.18 mm at 1 m"));
  EXPECT_THAT(page, HasSubstr("75</b>"));
  EXPECT_THAT(page, HasSubstr("B/W camera: distortion k2 (0.800)"));
  EXPECT_THAT(page, HasSubstr("no pictures of the floor"));
  EXPECT_THAT(page, HasSubstr("What is fixed, not estimated"));
}

TEST(CalibrationPage, NothingWeakIsSaidToo) {
  EXPECT_THAT(WeakInWords(Record(false)), HasSubstr("Every unknown is told by the pictures"));
  EXPECT_THAT(WeakInWords(Record(true)), Not(HasSubstr("focal length")));
}

}  // namespace
}  // namespace geon::cli
