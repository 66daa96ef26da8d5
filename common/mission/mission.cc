#include "mission/mission.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"
#include "base/plain_name.h"

namespace geon::mission {

namespace {

MissionOptions Checked(const MissionOptions& options) {
  std::string error;
  Require(options.IsValid(&error), error);
  return options;
}

// A floor picture younger than this is as good as a new one; older than that, the robot stops.
constexpr double kFresh_s = 0.5;
constexpr double kBlind_s = 1.2;

// After all devices answer: the sonar ring once round, and a picture. The light of a room is not
// known before; by a floor's colour in other light the robot would see floor nowhere.
constexpr double kLearnFloor_s = 1.8;

constexpr double kOneTarget_m = 0.35;  // scans so near to each other are of one target

bool Drives(Phase phase) {
  return phase == Phase::kTravel || phase == Phase::kSearch || phase == Phase::kApproach ||
         phase == Phase::kBackOff;
}

std::vector<Eigen::Vector2d> InWorld(const geometry::RigidTransform& X_WR,
                                     std::span<const Eigen::Vector2d> points_R_m) {
  std::vector<Eigen::Vector2d> points_W_m;
  for (const Eigen::Vector2d& p_m : points_R_m) {
    points_W_m.push_back(geometry::OnGround(X_WR, p_m));
  }
  return points_W_m;
}

std::string Sentence(const sensor::GeonVerdict& verdict) {
  const std::string name = PlainName(verdict.label);
  const std::string a_name = (verdict.label == GeonLabel::kEllipsoid ? "an " : "a ") + name;
  return verdict.decided ? "the geon is " + a_name
                         : "the evidence does not decide; nearest is " + a_name;
}

}  // namespace

Mission::Mission(const MissionOptions& options, const geometry::SensorRig& rig, int64_t run_id,
                 double now_s)
    : options_(Checked(options)),
      rig_(rig),
      context_{options_,
               rig_,
               Senses(options, rig),
               Head(run_id),
               Drive(options, options.seed),
               MapDrive(options),
               TargetTrack(options.looking, rig),
               navigation::ViewCoverage(options.looking.support_heights_m),
               {},
               std::nullopt,
               std::nullopt,
               {},
               {},
               {},
               run_id,
               0.0,
               options.looking.stop_distance_m,
               std::nullopt,
               {},
               {},
               {},
               "waiting for the devices",
               0,
               0},
      started_s_(now_s),
      last_s_(now_s) {
  Require(run_id > 0, "Mission: run_id must be positive");
}

Wishes Mission::Step(double now_s) {
  Require(now_s >= last_s_, "Mission::Step: time must not run backwards");
  const double step_s = now_s - last_s_;
  last_s_ = now_s;
  context_.wishes = {};
  if (phase_ != Phase::kDone) {
    context_.senses.SetFocus(FocusNow());
    context_.senses.Look(now_s);
    Transition next;
    if (now_s - started_s_ > options_.patience.mission_s) {
      next = Next{Phase::kDone, "the mission's time is over, in phase " +
                                    std::string(ToString(phase_)) + ": " + context_.text};
    } else if (const char* device = MissingDevice(now_s)) {
      next = Pause(now_s, device);
    } else {
      missing_since_s_.reset();
      context_.time_s += step_s;
      next = CheckContact();
      if (!next) {
        next = StepPhase();
        if (next && next->phase == Phase::kDone) next = Conclude(*next);
      }
    }
    if (next) Enter(*next);
  }
  context_.profiles.clear();
  context_.verdicts.clear();
  context_.wishes.head = context_.head.Command(now_s, context_.senses.ptu());
  Bound(now_s, &context_.wishes.velocity);
  return context_.wishes;
}

const char* Mission::MissingDevice(double now_s) const {
  const Senses& senses = context_.senses;
  if (senses.PtuLost(now_s)) return "the pan-tilt unit (PTU_STATE)";
  if (senses.BaseLost(now_s)) return "the base (BASE_STATE)";
  if (phase_ == Phase::kScan) {
    return senses.StripeCameraLost(now_s) ? "the stripe camera (LASER_STATE)" : nullptr;
  }
  if (senses.HeadCameraLost(now_s)) return "the head camera (COLOR_IMAGE)";
  if (senses.FloorCameraLost(now_s)) return "the floor camera (FLOOR_IMAGE)";
  return nullptr;
}

Transition Mission::Pause(double now_s, const char* device) {
  if (!missing_since_s_) {
    missing_since_s_ = now_s;
    context_.drive.Rest();
  }
  context_.text = std::string("waiting for ") + device;
  if (now_s - *missing_since_s_ <= options_.patience.device_s) return std::nullopt;
  return Next{Phase::kDone, std::string(device) + " does not answer"};
}

Transition Mission::CheckContact() {
  const auto bearing_rad = context_.senses.Contact();
  if (!bearing_rad || phase_ == Phase::kBackOff || phase_ == Phase::kWait) return std::nullopt;
  if (!Drives(phase_)) return std::nullopt;  // the robot stands; whatever touches it came to it
  if (context_.counters.bumps++ >= options_.patience.bumps) {
    return Next{Phase::kDone, "the robot bumped into things too often"};
  }
  Next away{Phase::kBackOff, "a bumper is pressed"};
  away.direction = std::cos(*bearing_rad) > 0.0 ? -1.0 : 1.0;
  return away;
}

bool Mission::StandsToLearnFloor() const {
  return options_.seeing.learn_floor && !context_.senses.floor_learned() &&
         context_.time_s < kLearnFloor_s;
}

Transition Mission::StepPhase() {
  switch (phase_) {
    case Phase::kWait:
      if (StandsToLearnFloor()) {
        context_.text = "standing still to hear all sonars and to learn the floor's colour";
        return std::nullopt;
      }
      return Next{options_.destination_W_m ? Phase::kTravel : Phase::kSearch, "all devices answer"};
    case Phase::kTravel:
      return travel_.Step(&context_);
    case Phase::kSearch:
      return search_.Step(&context_);
    case Phase::kApproach:
      return approach_.Step(&context_);
    case Phase::kCentre:
      return centre_.Step(&context_);
    case Phase::kBackOff:
      return back_off_.Step(&context_);
    case Phase::kScan:
      return scan_.Step(&context_);
    case Phase::kDone:
      break;
  }
  return std::nullopt;
}

Focus Mission::FocusNow() const {
  Focus focus;
  focus.ignored_W_m = context_.ignored_W_m;
  if (phase_ == Phase::kSearch) return focus;
  for (const SupportHypothesis& target : context_.target.hypotheses()) {
    if (target.sightings == 0) continue;
    focus.expected_W_m.emplace_back(target.p_WFoot_m.x(), target.p_WFoot_m.y(),
                                    target.support_height_m + kTargetMiddle_m);
  }
  return focus;
}

Transition Mission::Conclude(const Next& end) {
  TargetViews& views = context_.views;
  if (end.verdict) {
    const SupportHypothesis* target = context_.target.Best();
    const Eigen::Vector2d robot_W_m = context_.senses.X_WR().translation().head<2>();
    const Eigen::Vector2d place_W_m =
        context_.scanned_W_m.value_or(target != nullptr ? target->p_WFoot_m : robot_W_m);
    // Another target than the one that was to be looked at again.
    if (views.count() > 0 && (views.middle_W_m() - place_W_m).norm() > kOneTarget_m) {
      FinishTarget("");
    }
    const Eigen::Vector2d out_m = robot_W_m - place_W_m;
    views.Add(*end.verdict, std::atan2(out_m.y(), out_m.x()), place_W_m);
  } else if (views.count() > 0 && context_.side_rad) {
    views.GiveUp(*context_.side_rad);
  }
  if (views.count() > 0) {
    if (auto again = LookAgain()) return again;
  }
  return NextGeon(end);
}

std::optional<Next> Mission::LookAgain() {
  const TargetViews& views = context_.views;
  if (options_.driving.planner != PlannerKind::kMap || views.Fused().decided ||
      views.count() >= options_.patience.views) {
    return std::nullopt;
  }
  context_.side_rad = views.NextBearing();
  if (!context_.side_rad) return std::nullopt;
  return Next{Phase::kApproach, "the evidence does not decide: looking from another side"};
}

std::optional<sensor::GeonVerdict> Mission::FinishTarget(const std::string& why) {
  std::optional<sensor::GeonVerdict> verdict;
  sensor::GeonFinding finding;
  finding.why = why;
  finding.views = context_.views.count();
  const auto ignore = [&](const Eigen::Vector2d& p_W_m, double support_height_m) {
    context_.ignored_W_m.emplace_back(p_W_m.x(), p_W_m.y(), support_height_m + kTargetMiddle_m);
  };
  const SupportHypothesis* target = context_.target.Best();
  if (target != nullptr) {
    finding.p_W_m = target->p_WFoot_m;
    finding.support_height_m = target->support_height_m;
  }
  if (finding.views > 0) {
    verdict = context_.views.Fused();
    finding.label = verdict->label;
    finding.confidence = verdict->confidence;
    finding.decided = verdict->decided;
    finding.posterior = verdict->posterior;
    finding.p_W_m = context_.views.middle_W_m();
    ignore(finding.p_W_m, finding.support_height_m);
  } else {
    // Not near enough to tell which support it stands on.
    for (const SupportHypothesis& support : context_.target.hypotheses()) {
      if (support.sightings > 0) ignore(support.p_WFoot_m, support.support_height_m);
    }
  }
  const bool known = std::any_of(context_.findings.begin(), context_.findings.end(),
                                 [&](const sensor::GeonFinding& other) {
                                   return (other.p_W_m - finding.p_W_m).norm() < kOneTarget_m;
                                 });
  if (!known) context_.findings.push_back(finding);
  context_.views.Clear();
  context_.side_rad.reset();
  context_.scanned_W_m.reset();
  context_.counters = {0, 0, 0, context_.counters.bumps, 0};
  return verdict;
}

Next Mission::NextGeon(const Next& end) {
  const bool seen =
      context_.views.count() > 0 || (phase_ != Phase::kSearch && phase_ != Phase::kTravel);
  std::optional<sensor::GeonVerdict> verdict;
  if (seen) verdict = FinishTarget(end.why);
  if (!options_.inventory) {
    Next done = end;
    done.verdict = verdict;
    if (verdict) done.outcome = sensor::MissionOutcome::kFailed;  // unless it is decided
    return done;
  }
  if (!seen) {
    Next done = end;
    if (!context_.findings.empty()) {
      done.outcome = sensor::MissionOutcome::kSurveyed;
      done.why = std::to_string(context_.findings.size()) +
                 " geons are done with, and there are no more to be seen in the reachable pen";
    }
    return done;
  }
  context_.target.Clear();
  return {Phase::kSearch, (verdict ? Sentence(*verdict) : end.why) + "; looking for more"};
}

void Mission::Enter(const Next& next) {
  phase_ = next.phase;
  context_.text = next.why;
  context_.wishes.velocity = {};
  switch (phase_) {
    case Phase::kWait:
      break;
    case Phase::kTravel:
      travel_.Enter(&context_);
      break;
    case Phase::kSearch:
      search_.Enter(&context_, next.near);
      break;
    case Phase::kApproach:
      approach_.Enter(&context_);
      break;
    case Phase::kCentre:
      centre_.Enter(&context_);
      break;
    case Phase::kBackOff:
      back_off_.Enter(&context_, next.direction);
      break;
    case Phase::kScan:
      scan_.Enter(&context_);
      break;
    case Phase::kDone:
      verdict_ = next.verdict;
      outcome_ = verdict_ && verdict_->decided ? sensor::MissionOutcome::kNamed : next.outcome;
      if (verdict_) context_.text = Sentence(*verdict_);
      context_.wishes.scan_command = sensor::ScanCommand();  // lasers off
      break;
  }
}

void Mission::Bound(double now_s, navigation::DriveVelocity* velocity) const {
  const auto bounded = [](double value, double limit) {
    return std::isfinite(value) ? std::clamp(value, -limit, limit) : 0.0;
  };
  const auto& limits = options_.driving.velocity;
  if (!Drives(phase_)) *velocity = {};
  // Ahead only as far as the floor camera has looked lately.
  const double age_s = context_.senses.floor_age_s(now_s);
  const double trust_1 = std::clamp((kBlind_s - age_s) / (kBlind_s - kFresh_s), 0.0, 1.0);
  if (velocity->speed_m_s > 0.0) velocity->speed_m_s *= trust_1;
  velocity->speed_m_s = bounded(velocity->speed_m_s, limits.max_speed_m_s);
  velocity->turn_rate_rad_s = bounded(velocity->turn_rate_rad_s, limits.max_turn_rate_rad_s);
}

sensor::PlannerState Mission::State() const {
  const Senses& senses = context_.senses;
  const geometry::RigidTransform X_WR = senses.X_WR();
  sensor::PlannerState state;
  state.phase = ToString(phase_);
  state.text = context_.text;
  state.outcome = outcome_;
  state.x_m = senses.base().x_m;
  state.y_m = senses.base().y_m;
  state.heading_rad = senses.base().heading_rad;
  if (const SupportHypothesis* target = context_.target.Best()) {
    state.p_WTarget_m = target->p_WFoot_m;
  }
  const bool by_map = options_.driving.planner == PlannerKind::kMap && phase_ != Phase::kBackOff;
  if (Drives(phase_)) {
    const auto show = [&](const auto& drive) {
      state.safe_polygon_W_m = InWorld(X_WR, drive.polygon_R().vertices());
      state.p_WWaypoint_m = InWorld(X_WR, std::span(&drive.waypoint_R_m(), 1)).front();
    };
    by_map ? show(context_.map_drive) : show(context_.drive);
  } else {
    state.p_WWaypoint_m = X_WR.translation().head<2>();
  }
  state.obstacles_W_m = InWorld(X_WR, senses.obstacles_R_m());
  state.scan_id = context_.scan_id;
  state.stripe_index = context_.stripe_index;
  state.findings = context_.findings;
  return state;
}

}  // namespace geon::mission
