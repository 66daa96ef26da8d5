#include "procs/geon/experiment_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/angles.h"
#include "evaluation/scan_conditions.h"
#include "procs/geon/experiment_conditions.h"

namespace geon::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

// Two objects, four views each; one answer is wrong.
ShapeRecord Example() {
  ShapeRecord record;
  record.method = "evidence";
  record.seed = 7;
  record.git = "abc<d>";
  record.conditions = {{"range_m", 1.3},      {"noise_px", 0.1}, {"stress", "realish"},
                       {"floor", false},      {"ortho", false},  {"elevation_deg", "30:50"},
                       {"family", "polygon"}, {"objects", ""},   {"meshes", ""},
                       {"curvature", nullptr}};
  record.subjects = {{GeonLabel::kCuboid, "1", 1}, {GeonLabel::kEllipsoid, "2", 1}};
  for (int t = 0; t < 8; ++t) {
    const int subject = t / 4;
    GeonLabel answer = record.subjects[static_cast<size_t>(subject)].truth;
    if (t == 5) answer = GeonLabel::kCylinder;
    record.trials.push_back(
        {t,
         subject,
         {RadiansFromDegrees(t % 4 < 2 ? 35 : 45), RadiansFromDegrees(t % 2 == 0 ? 5 : 15)},
         answer,
         0.75,
         t != 0});
  }
  WorstView view{5, false, 0.75, {0.0, 0.75, 0.25, 0.0, 0.0, 0.0, 0.0}, {"3 < 4 & so on"}, {}, {}};
  view.stripes = {{sensor::Laser::kHorizontal, 0.5, {{{-500, 0, 10000}, {500, 0, 10100}}}},
                  {sensor::Laser::kVertical, 0.5, {}}};
  record.worst = {view};
  return record;
}

TEST(ExperimentPage, TellsRateAndConditionsInWords) {
  const std::string page = ExperimentPage(Example());
  EXPECT_THAT(page, HasSubstr("87.5 % of 8 views named rightly"));
  EXPECT_THAT(page, HasSubstr("95 % interval: 52.9 to 97.8 %"));
  EXPECT_THAT(page, HasSubstr("Method “evidence”"));
  EXPECT_THAT(page, HasSubstr("from 30° to 50° above"));
  EXPECT_THAT(page, HasSubstr("Camera 1.3 m from the middle"));
  EXPECT_THAT(page, HasSubstr("Seed 7, build abc&lt;d&gt;."));
}

TEST(ExperimentPage, DrawsEveryFigure) {
  const std::string page = ExperimentPage(Example());
  EXPECT_THAT(page, HasSubstr("cuboid called cuboid: 4 of 4 views, 100.0 %; thesis 83.0 %"));
  EXPECT_THAT(page, HasSubstr("ellipsoid, object 2, pos. 1 called cylinder: 1 of 4 views"));
  EXPECT_THAT(page, HasSubstr("elevation 35°, azimuth 15°: 1 of 2 wrong"));
  EXPECT_THAT(page, HasSubstr("confidence 0.73 to 0.80, mean 0.750: 7 of 8 right"));
  EXPECT_THAT(page, HasSubstr("<b>12.50 %</b>"));
  EXPECT_THAT(page, HasSubstr("<td>undecided</td><td class=\"number\">1</td>"));
}

TEST(ExperimentPage, ShowsTheWorstViewsAndTheirEvidence) {
  const std::string page = ExperimentPage(Example());
  EXPECT_THAT(page, HasSubstr("The only wrong answer."));
  EXPECT_THAT(page, HasSubstr("1. An ellipsoid, taken for a cylinder"));
  EXPECT_THAT(page, HasSubstr("elevation 35°, azimuth 15°; trial 5."));
  EXPECT_THAT(page, HasSubstr("3 &lt; 4 &amp; so on"));
  EXPECT_THAT(page, HasSubstr("stripe horizontal"));
  EXPECT_THAT(page, HasSubstr("Vertical ½ from the left: nothing"));
}

TEST(ExperimentPage, SaysWhenNothingIsWrong) {
  ShapeRecord record = Example();
  record.trials[5].answer = GeonLabel::kEllipsoid;
  record.worst[0].right = true;
  const std::string page = ExperimentPage(record);
  EXPECT_THAT(page, HasSubstr("Nothing is wrong."));
  EXPECT_THAT(page, HasSubstr("An ellipsoid, rightly named"));
  record.worst.clear();
  EXPECT_THAT(ExperimentPage(record), HasSubstr("keeps no views"));
}

TEST(ExperimentPage, NeedsNothingFromElsewhere) {
  const std::string page = ExperimentPage(Example());
  for (const char* word : {"http", "<script", "<link", "url(", "@import"}) {
    EXPECT_THAT(page, Not(HasSubstr(word)));
  }
}

TEST(ExperimentPage, OtherObjectsStandWithoutTheThesis) {
  ShapeRecord record = Example();
  record.conditions["objects"] = "mine<.yaml";
  const std::string page = ExperimentPage(record);
  EXPECT_THAT(page, Not(HasSubstr("; thesis ")));
  EXPECT_THAT(page, Not(HasSubstr("In brackets")));
  EXPECT_THAT(page, HasSubstr("2 objects of mine&lt;.yaml"));
}

TEST(ExperimentPage, AShardWithoutTrialsIsToldToo) {
  ShapeRecord record = Example();
  record.trials.clear();
  record.worst.clear();
  EXPECT_THAT(ExperimentPage(record), HasSubstr("No trials"));
}

TEST(ConditionsInWords, NameEveryStress) {
  ShapeRecord record = Example();
  EXPECT_THAT(ConditionsInWords(record), HasSubstr("stand on a floor"));
  EXPECT_THAT(ConditionsInWords(record), HasSubstr("made of polygons"));
  for (const evaluation::Stress& stress : evaluation::Stresses()) {
    record.conditions["stress"] = stress.name;
    const std::string expected =
        stress.name == "none" ? "No other fault." : "“" + stress.name + "”: ";
    EXPECT_THAT(ConditionsInWords(record), HasSubstr(expected));
  }
  record.conditions["stress"] = "attitude";
  EXPECT_THAT(ConditionsInWords(record), HasSubstr("attitude wrong by 1.5°."));
}

TEST(ConditionsInWords, LeaveOutWhatIsNotSaid) {
  ShapeRecord record = Example();
  record.conditions = {{"range_m", nullptr}};
  EXPECT_EQ(
      ConditionsInWords(record),
      "The 2 objects of the thesis in 2 positions. The objects hang in the air; what camera or "
      "laser cannot see is a gap. ");
}

}  // namespace
}  // namespace geon::cli
