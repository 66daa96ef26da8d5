#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "procs/geon/bench_page.h"
#include "procs/geon/bench_record.h"

namespace geon::cli {
namespace {

using testing::HasSubstr;

BenchRecord OneCuboidTakenForACylinder() {
  BenchRecord record;
  record.method = "thesis";
  record.conditions = {{"poses", 1}};
  BenchTrialRecord trial;
  trial.subject = {GeonLabel::kCuboid, "2", 1};
  trial.range_m = 1.6;
  trial.answer = GeonLabel::kCylinder;
  trial.confidence = 0.6;
  trial.end = "the geon is a cylinder";
  record.trials = {trial};
  AddWorstView({0, false, 0.6, {}, {"two curves"}, {}, "data:image/jpeg;base64,AA=="},
               &record.worst);
  return record;
}

TEST(BenchTablesTest, StandBesideTheThesis) {
  const std::string text = BenchTables(OneCuboidTakenForACylinder());
  EXPECT_THAT(text, HasSubstr("At 1.60 m"));
  EXPECT_THAT(text, testing::ContainsRegex("cuboid .* 0  \\(50\\) +100  \\(30\\)"));
  EXPECT_THAT(text, HasSubstr("the thesis 63.3 %"));
  EXPECT_EQ(BenchTables({}), "No trials.\n");
}

TEST(BenchPageTest, ShowsWhatWentWrongWithItsPicture) {
  const std::string page = BenchPage(OneCuboidTakenForACylinder());
  EXPECT_THAT(page, HasSubstr("A cuboid, taken for a cylinder"));
  EXPECT_THAT(page, HasSubstr("data:image/jpeg;base64,AA=="));
  EXPECT_THAT(page, HasSubstr("two curves"));
  EXPECT_THAT(page, HasSubstr("the geon is a cylinder"));
  EXPECT_THAT(BenchPage({}), HasSubstr("No trials"));
}

}  // namespace
}  // namespace geon::cli
