// Conversions of what planner and recognizer publish (messaging/wire.h).
#include <gtest/gtest.h>

#include <cmath>

#include "base/contracts.h"
#include "messaging/codec.h"
#include "messaging/wire.h"
#include "tests/common/messaging/sample_messages.h"

namespace geon::messaging {
namespace {

TEST(WireMission, ScanPlanSurvivesTheRoundTrip) {
  const auto plan = Decode<sensor::ScanPlan>(Encode(samples::ScanPlan()));
  ASSERT_TRUE(plan.ok()) << plan.message();
  EXPECT_EQ(plan->target_box, (sensor::PixelBox{1, 2, 30, 40}));
  EXPECT_EQ(plan->support_height_m, 0.7);
  ASSERT_EQ(plan->stripes.size(), 2u);
  EXPECT_EQ(plan->stripes[1].laser, sensor::Laser::kVertical);
  EXPECT_EQ(plan->stripes[1].tilt_rad, -0.25);
}

TEST(WireMission, TargetMaskSurvivesTheRoundTrip) {
  const sensor::TargetMask sent = samples::TargetMask();
  const auto got = Decode<sensor::TargetMask>(Encode(sent));
  ASSERT_TRUE(got.ok()) << got.message();
  EXPECT_EQ(got->scan_id, 77);
  EXPECT_EQ(got->box, sent.box);
  EXPECT_EQ(got->tilt_rad, -0.3);
  EXPECT_EQ(got->runs_px, sent.runs_px);
}

TEST(WireMission, AMaskMustFillItsBox) {
  sensor::TargetMask mask = samples::TargetMask();
  mask.runs_px.push_back(1);
  EXPECT_EQ(FromWire(ToWire(mask)).message(), "runs_px do not fill the box");
  mask.runs_px = {7, -1};
  EXPECT_EQ(FromWire(ToWire(mask)).message(), "runs_px has a negative length");
  mask.box.w_px = 0;
  EXPECT_EQ(FromWire(ToWire(mask)).message(), "box is empty or lies in no picture");
  mask.box.w_px = 1000000;
  EXPECT_FALSE(FromWire(ToWire(mask)).ok());
}

TEST(WireMission, RangeProfileSurvivesTheRoundTrip) {
  const sensor::RangeProfile sent = samples::RangeProfile();
  const auto got = Decode<sensor::RangeProfile>(Encode(sent));
  ASSERT_TRUE(got.ok()) << got.message();
  EXPECT_EQ(got->attempt, 1);
  EXPECT_EQ(got->status, sensor::ProfileStatus::kMissing);
  EXPECT_EQ(got->on_target, 1);
  EXPECT_EQ(got->pixel, sent.pixel);
  EXPECT_EQ(got->p_L_m, sent.p_L_m);
  ASSERT_TRUE(got->rotation_LB.has_value());
  EXPECT_EQ(*got->rotation_LB, *sent.rotation_LB);
  ASSERT_TRUE(got->laser_origin_L_m.has_value());
  EXPECT_EQ(*got->laser_origin_L_m, *sent.laser_origin_L_m);
}

TEST(WireMission, AbsentPosesStayAbsent) {
  sensor::RangeProfile sent = samples::RangeProfile();
  sent.rotation_LB.reset();
  sent.laser_origin_L_m.reset();
  const auto got = Decode<sensor::RangeProfile>(Encode(sent));
  ASSERT_TRUE(got.ok()) << got.message();
  EXPECT_FALSE(got->rotation_LB.has_value());
  EXPECT_FALSE(got->laser_origin_L_m.has_value());
}

TEST(WireMission, AProfileMustBeOrderedAndFinite) {
  geon::range_profile_t wire = ToWire(samples::RangeProfile());
  wire.pixel = {5, 5};
  EXPECT_EQ(FromWire(wire).message(), "pixel is not strictly increasing");
  wire = ToWire(samples::RangeProfile());
  wire.z_m[1] = std::nan("");
  EXPECT_FALSE(FromWire(wire).ok());
  sensor::RangeProfile unequal = samples::RangeProfile();
  unequal.pixel.push_back(9);
  EXPECT_THROW(Encode(unequal), ContractViolation);
}

TEST(WireMission, VerdictSurvivesTheRoundTrip) {
  const sensor::GeonVerdict sent = samples::Verdict();
  const auto got = Decode<sensor::GeonVerdict>(Encode(sent));
  ASSERT_TRUE(got.ok()) << got.message();
  EXPECT_EQ(got->label, GeonLabel::kBentCylinder);
  EXPECT_EQ(got->posterior, sent.posterior);
  EXPECT_TRUE(got->decided);
  EXPECT_EQ(got->method, "thesis");
  EXPECT_TRUE(got->bending.concavity);
  EXPECT_FALSE(got->bending.two_segments);
  EXPECT_EQ(got->bending.concave_edge_m, 0.01);
  EXPECT_TRUE(got->tapering.monotone_horizontal);
  EXPECT_TRUE(got->tapering.asymmetric_ends);
  ASSERT_EQ(got->profiles.size(), 2u);
  EXPECT_EQ(got->profiles[1].curves, 2);
  EXPECT_EQ(got->profiles[1].theta_rad, (std::vector<double>{0.5, 0.6}));
  EXPECT_EQ(got->reasons, sent.reasons);
}

TEST(WireMission, AVerdictWithAnUnknownLabelIsRefused) {
  geon::verdict_t wire = ToWire(samples::Verdict());
  wire.label = 7;
  EXPECT_EQ(FromWire(wire).message(), "label has the unknown value 7");
  wire = ToWire(samples::Verdict());
  wire.profiles[1].laser = -1;
  EXPECT_EQ(FromWire(wire).message(), "profiles: laser has the unknown value -1");
}

TEST(WireMission, PlannerStateSurvivesTheRoundTrip) {
  sensor::PlannerState sent = samples::PlannerState();
  const auto got = Decode<sensor::PlannerState>(Encode(sent));
  ASSERT_TRUE(got.ok()) << got.message();
  EXPECT_EQ(got->phase, "approach");
  EXPECT_EQ(got->p_WTarget_m, sent.p_WTarget_m);
  EXPECT_EQ(got->safe_polygon_W_m, sent.safe_polygon_W_m);
  EXPECT_EQ(got->obstacles_W_m, sent.obstacles_W_m);
  EXPECT_EQ(got->stripe_index, 3);
  sent.p_WTarget_m.reset();
  EXPECT_FALSE(Decode<sensor::PlannerState>(Encode(sent))->p_WTarget_m.has_value());
}

TEST(WireMission, FindingsSurviveTheRoundTrip) {
  const sensor::PlannerState sent = samples::PlannerState();
  const auto got = Decode<sensor::PlannerState>(Encode(sent));
  ASSERT_TRUE(got.ok()) << got.message();
  ASSERT_EQ(got->findings.size(), 2u);
  const sensor::GeonFinding& named = got->findings[0];
  EXPECT_EQ(named.label, GeonLabel::kBentCylinder);
  EXPECT_EQ(named.confidence, 0.8);
  EXPECT_TRUE(named.decided);
  EXPECT_EQ(named.posterior, sent.findings[0].posterior);
  EXPECT_EQ(named.p_W_m, Eigen::Vector2d(1.5, -2.5));
  EXPECT_EQ(named.support_height_m, 0.7);
  EXPECT_EQ(named.views, 2);
  EXPECT_EQ(named.why, "");
  const sensor::GeonFinding& unscanned = got->findings[1];
  EXPECT_FALSE(unscanned.label.has_value());
  EXPECT_FALSE(unscanned.decided);
  EXPECT_EQ(unscanned.views, 0);
  EXPECT_EQ(unscanned.why, "unreachable");
}

TEST(WireMission, AFindingWithAnUnknownLabelIsRefused) {
  geon::planner_state_t wire = ToWire(samples::PlannerState());
  wire.findings[1].label = 7;
  EXPECT_EQ(FromWire(wire).message(), "findings: label has the unknown value 7");
  wire.findings[1].label = -2;
  EXPECT_FALSE(FromWire(wire).ok());
  wire = ToWire(samples::PlannerState());
  wire.findings[0].confidence_1 = std::nan("");
  EXPECT_FALSE(FromWire(wire).ok());
}

TEST(WireMission, EveryOutcomeSurvivesTheRoundTripAndOthersAreRefused) {
  using sensor::MissionOutcome;
  for (const MissionOutcome outcome :
       {MissionOutcome::kRunning, MissionOutcome::kNamed, MissionOutcome::kFailed,
        MissionOutcome::kUnreachable, MissionOutcome::kNoneFound, MissionOutcome::kSurveyed}) {
    sensor::PlannerState sent = samples::PlannerState();
    sent.outcome = outcome;
    EXPECT_EQ(Decode<sensor::PlannerState>(Encode(sent))->outcome, outcome);
  }
  geon::planner_state_t wire = ToWire(samples::PlannerState());
  wire.outcome = 6;
  EXPECT_EQ(FromWire(wire).message(), "outcome has the unknown value 6");
}

TEST(WireMission, TargetViewSurvivesTheRoundTrip) {
  sensor::TargetView sent = samples::TargetView();
  const auto got = Decode<sensor::TargetView>(Encode(sent));
  ASSERT_TRUE(got.ok()) << got.message();
  EXPECT_EQ(got->target_box, sent.target_box);
  EXPECT_EQ(got->target_pixels, 900);
  EXPECT_EQ(got->view.format, sensor::PixelFormat::kJpeg);
  EXPECT_EQ(got->mask.data, sent.mask.data);
  sent.target_box.reset();
  EXPECT_FALSE(Decode<sensor::TargetView>(Encode(sent))->target_box.has_value());
}

}  // namespace
}  // namespace geon::messaging
