#pragma once

#include <cstdint>
#include <optional>

#include "geometry/sensor_rig.h"
#include "mission/approach_phase.h"
#include "mission/back_off_phase.h"
#include "mission/centre_phase.h"
#include "mission/mission_options.h"
#include "mission/phase.h"
#include "mission/scan_phase.h"
#include "mission/search_phase.h"
#include "mission/travel_phase.h"
#include "sensor/planner_state.h"

namespace geon::mission {

// The robot's job as a state machine: drive to the destination, if there is one; find a geon, drive
// up to it, centre it, lay six stripes, get a verdict. What was heard and the time go in, wishes
// come out; nothing here waits, sleeps or sends, so that the same mission runs in a daemon and in
// virtual time.
//
// With the planner `map` a target that the verdict does not decide on is looked at again from
// another side, and all views are weighed together; with `inventory` the mission goes on until all
// geons that can be seen are done with (PlannerState::findings).
//
// Source: thesis chapter 4; every failure it names is a transition: target lost (search around it),
// too large (step back), out of range, stripe missing (asked for again before the head moves on),
// trapped (wander). So are a device that restarts (the phase's time stands still meanwhile) and a
// contact (stop, move away). Every mission ends, at the latest after PatienceOptions::mission_s,
// with a verdict or a reason.
//
// Safety: no wish to drive while a scan runs or a needed device is away; velocities finite and
// within limits, always.
class Mission {
 public:
  // `run_id` > 0 makes the ids of this run's commands and scans differ from those of every earlier
  // run: the start time in microseconds does. `now_s` is the planner's own clock, as in every call
  // below.
  Mission(const MissionOptions& options, const geometry::SensorRig& rig, int64_t run_id,
          double now_s);
  Mission(const Mission&) = delete;
  Mission& operator=(const Mission&) = delete;

  // What the robot's daemons and the recognizer said.
  Senses* senses() { return &context_.senses; }
  void Take(const sensor::RangeProfile& profile) { context_.profiles.push_back(profile); }
  void Take(const sensor::GeonVerdict& verdict) { context_.verdicts.push_back(verdict); }

  // One step, some 20 times a second. Wishes hold until the next one.
  Wishes Step(double now_s);

  Phase phase() const { return phase_; }
  sensor::MissionOutcome outcome() const { return outcome_; }
  const std::optional<sensor::GeonVerdict>& verdict() const { return verdict_; }
  // For people and logs; utime and seq are the sender's.
  sensor::PlannerState State() const;

 private:
  // The device that the present phase cannot do without and that does not answer; nullptr: none.
  const char* MissingDevice(double now_s) const;
  void Enter(const Next& next);
  bool StandsToLearnFloor() const;
  Transition StepPhase();
  // What it means for the mission that a phase ended with a verdict, or with a reason why there is
  // none: look again, go on to the next geon, or end.
  Transition Conclude(const Next& end);
  std::optional<Next> LookAgain();
  // Its verdict, if it was ever scanned. One that is done with already is not kept twice.
  std::optional<sensor::GeonVerdict> FinishTarget(const std::string& why);
  Next NextGeon(const Next& end);
  Focus FocusNow() const;
  Transition CheckContact();
  Transition Pause(double now_s, const char* device);
  void Bound(double now_s, navigation::DriveVelocity* velocity) const;

  MissionOptions options_;
  geometry::SensorRig rig_;
  Context context_;
  Phase phase_ = Phase::kWait;
  TravelPhase travel_;
  SearchPhase search_;
  ApproachPhase approach_;
  CentrePhase centre_;
  BackOffPhase back_off_;
  ScanPhase scan_;
  double started_s_;
  double last_s_;
  std::optional<double> missing_since_s_;
  sensor::MissionOutcome outcome_ = sensor::MissionOutcome::kRunning;
  std::optional<sensor::GeonVerdict> verdict_;
};

}  // namespace geon::mission
