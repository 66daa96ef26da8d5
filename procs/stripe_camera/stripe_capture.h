#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "device/laser_driver.h"
#include "procs/stripe_camera/stripe_proof.h"
#include "procs/stripe_camera/stripe_sweep.h"
#include "sensor/base.h"
#include "sensor/image.h"
#include "sensor/ptu.h"
#include "sensor/stripe.h"

namespace geon::stripe_camera {

struct StripeCaptureOptions {
  int frames_per_stripe = 1;       // lit and unlit frames that are averaged
  int lit_tries = 3;               // sets of lit frames looked at before "not lit"
  double settle_s = 0.010;         // after the board's ok, before an exposure may begin
  double still_s = 0.15;           // the head must have stood so long: it swings on
  double wait_still_s = 1.5;       // how long a request waits for head and base to stand
  double state_timeout_s = 1.0;    // states older than that say nothing
  double laser_timeout_s = 4.0;    // for the board's ok; a restart of the board fits in
  double frame_timeout_s = 2.5;    // for a frame that may be used
  double request_timeout_s = 1.0;  // after the last request: laser off, request forgotten
  double exposure_s = 0.008;       // of a frame
  StripeProofOptions proof;
};

// Decides which laser shall burn and which frames count, one request at a time:
//
//   head and base stand -> an unlit frame (exposure begun after "off" was confirmed and settled)
//   -> laser on -> a lit frame (likewise after "on") that shows the stripe -> laser off
//   -> a later head state that says nothing moved -> the stripe.
//
// No clock, no port: everything comes with the time of one monotonic clock. A laser is wanted only
// while lit frames are awaited and head and base are known to stand; in every other state of this
// class the answer to wanted_laser() is "none". A request that was answered is answered from memory
// when it is repeated; one that is no longer repeated is forgotten. What is asked of a sweep goes
// to StripeSweep.
class StripeCapture {
 public:
  explicit StripeCapture(const StripeCaptureOptions& options = {});

  void OnCommand(const sensor::ScanCommand& command, double time_s);
  void OnPtuState(const sensor::PtuState& state, double time_s);
  void OnBaseState(const sensor::BaseState& state, double time_s);
  void OnLaser(const device::LaserReport& report, double time_s);
  // `start_s`: when the exposure began, on the same clock.
  void OnFrame(const sensor::Image& grey, double start_s, double time_s);
  void Tick(double time_s);

  // Whether a frame whose exposure began at `start_s` would be used, were it here now.
  bool WantsFrame(double start_s, double time_s) const;
  sensor::Laser wanted_laser(double time_s) const;
  // Answers to publish, in order; the difference is kGray8, seq and the utime of refusals are not
  // set.
  std::vector<sensor::Stripe> TakeAnswers();
  // What the last refusal said, for the log.
  const std::string& reason() const { return reason_; }

 private:
  enum class Phase { kIdle, kWaitStill, kUnlit, kLit, kPose };
  struct Answer {
    sensor::Stripe stripe;
    double answered_s;
  };

  void Begin(Phase phase, double time_s);
  bool AnswerFromMemory(const sensor::ScanCommand& command, double time_s);
  sensor::Laser needed_laser() const;
  bool IsLaser(sensor::Laser laser) const;
  // Why nothing may burn or be exposed now; empty when head and base stand.
  std::string WhyNotStanding(double time_s) const;
  void UseFrame(const sensor::Image& grey, double start_s, double time_s);
  void JudgeLitFrames(double time_s);
  void CheckPose(double time_s);
  void CheckTimeouts(double time_s);
  void Refuse(sensor::StripeStatus status, const std::string& why, double time_s);
  void Finish(sensor::StripeStatus status, double time_s);

  StripeCaptureOptions options_;
  StripeSweep sweep_;
  Phase phase_ = Phase::kIdle;
  double phase_since_s_ = 0.0;
  sensor::ScanCommand request_;
  double last_request_s_ = 0.0;
  std::string reason_;

  std::optional<sensor::PtuState> ptu_;
  double ptu_received_s_ = 0.0;
  double ptu_still_since_s_ = 0.0;
  std::optional<sensor::BaseState> base_;
  double base_received_s_ = 0.0;
  device::LaserReport laser_;

  sensor::Stripe stripe_;  // being made
  FrameSum unlit_;
  FrameSum lit_;
  double last_start_s_ = 0.0;
  double lit_received_s_ = 0.0;
  int tries_ = 0;

  std::deque<Answer> memory_;
  std::vector<sensor::Stripe> answers_;
};

}  // namespace geon::stripe_camera
