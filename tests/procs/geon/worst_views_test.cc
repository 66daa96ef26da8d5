#include "procs/geon/worst_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "evaluation/scan_maker.h"
#include "evaluation/shape_experiment.h"
#include "geons/polygon_geon.h"

namespace geon::cli {
namespace {

WorstView View(int t, bool right, double confidence_1) {
  return {t, right, confidence_1, {}, {}, {}, {}};
}

std::vector<int> Trials(const std::vector<WorstView>& views) {
  std::vector<int> trials;
  for (const WorstView& view : views) trials.push_back(view.t);
  return trials;
}

std::vector<WorstView> WorstOf(const std::vector<WorstView>& views) {
  std::vector<WorstView> worst;
  for (const WorstView& view : views) AddWorstView(view, &worst);
  return worst;
}

TEST(WorstViews, TheMostConfidentWrongAnswerComesFirst) {
  EXPECT_EQ(Trials(WorstOf({View(0, false, 0.5), View(1, true, 0.2), View(2, false, 0.9),
                            View(3, false, 0.9)})),
            (std::vector{2, 3, 0}));
}

TEST(WorstViews, WhenNothingIsWrongTheLeastConfidentComesFirst) {
  EXPECT_EQ(Trials(WorstOf({View(0, true, 0.9), View(1, true, 0.2), View(2, true, 0.5)})),
            (std::vector{1, 2, 0}));
}

TEST(WorstViews, AreThoseOfTheWholeHoweverItWasSpread) {
  std::mt19937 random(5);
  for (const int wrong_percent : {0, 3, 50}) {
    std::vector<WorstView> all;
    for (int t = 0; t < 300; ++t) {
      all.push_back(View(t, static_cast<int>(random() % 100) >= wrong_percent,
                         0.1 * static_cast<double>(random() % 8)));
    }
    const std::vector<int> whole = Trials(WorstOf(all));
    for (const size_t shards : {2U, 7U, 60U}) {
      std::vector<std::vector<WorstView>> parts(shards);
      for (size_t t = 0; t < all.size(); ++t) AddWorstView(all[t], &parts[t % shards]);
      std::shuffle(parts.begin(), parts.end(), random);
      std::vector<WorstView> joined;
      for (const auto& part : parts) {
        EXPECT_LE(part.size(), kMostWorstViews);
        for (const WorstView& view : part) AddWorstView(view, &joined);
      }
      EXPECT_EQ(Trials(joined), whole);
    }
  }
}

TEST(WorstViews, DrawTheSixStripesOfTheTarget) {
  const geons::GeonShape box{GeonLabel::kCuboid, {0.10, 0.10, 0.10}};
  const evaluation::ObjectTracer tracer(geons::PolygonGeon(box, 32));
  evaluation::SphereConditions conditions;
  conditions.floor = true;
  const sensor::ScanSet scan =
      evaluation::MakeTrialScan(tracer, evaluation::ViewingSphere().front(), 0, conditions);
  const std::vector<DrawnStripe> stripes = DrawStripes(scan);
  ASSERT_EQ(stripes.size(), 6U);
  for (const DrawnStripe& stripe : stripes) {
    size_t points = 0;
    for (const auto& piece : stripe.pieces) {
      points += piece.size();
      for (const Eigen::Vector3i& p : piece) {  // within the box, about 1 m before the camera
        EXPECT_LT(p.head<2>().cwiseAbs().maxCoeff(), 900);
        EXPECT_NEAR(p.z(), 10000, 1000);
      }
    }
    EXPECT_GT(points, 20U);
    EXPECT_LT(points, 120U);
  }
}

TEST(WorstViews, AreTheSameAfterWritingAndReading) {
  WorstView view = View(7, false, 0.5);
  view.posterior = {0.5, 0.25, 0.125, 0.1, 0.025, 0.0, 0.0};
  view.reasons = {"because"};
  view.stripes = {{sensor::Laser::kVertical, 0.25, {{{1, 2, 3}, {4, 5, 6}}, {{7, 8, 9}}}}};
  const nlohmann::json json = ToJson(view);
  EXPECT_EQ(ToJson(ParseWorstView(json)), json);
  EXPECT_EQ(ParseWorstView(json).stripes[0].pieces[1][0], Eigen::Vector3i(7, 8, 9));
}

TEST(WorstViews, RefuseDamagedStripes) {
  WorstView view = View(7, false, 0.5);
  view.stripes = {{sensor::Laser::kVertical, 0.25, {{{1, 2, 3}}}}};
  nlohmann::json json = ToJson(view);
  json["stripes"][0]["pieces_tenth_mm"][0].push_back(4);
  EXPECT_ANY_THROW(ParseWorstView(json));
  json = ToJson(view);
  json["stripes"][0]["laser"] = "green";
  EXPECT_ANY_THROW(ParseWorstView(json));
  json = ToJson(view);
  json["posterior"].erase("cuboid");
  EXPECT_ANY_THROW(ParseWorstView(json));
}

}  // namespace
}  // namespace geon::cli
