#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "device/laser_driver.h"
#include "procs/stripe_camera/stripe_proof.h"
#include "sensor/base.h"
#include "sensor/image.h"
#include "sensor/ptu.h"
#include "sensor/stripe.h"

namespace geon::stripe_camera {

struct StripeSweepOptions {
  // Of a frame that does not say: its stripe is that of the middle of the exposure.
  double exposure_s = 0.008;
  double settle_s = 0.010;         // after the board's ok, before an exposure may begin
  double state_timeout_s = 1.0;    // states older than that say nothing
  double request_timeout_s = 1.0;  // after the last request: laser off, request forgotten
  double history_s = 0.5;          // of head states, and so long a frame waits for the next one
  StripeProofOptions proof;
};

// Stripes while the head turns: as long as a sweep is asked for, its laser burns and every frame
// that shows its stripe is one of the scan, with the pose that the head had at the middle of the
// exposure, between the head states before and after it. There is no unlit frame of the same view:
// a stripe is measured above the median of its own frame, which the camera's filter keeps dark.
//
// No clock, no port, as in StripeCapture. The laser burns only while the base is known to stand.
class StripeSweep {
 public:
  explicit StripeSweep(const StripeSweepOptions& options = {});

  // A sweep (kSweptStripe) begins or goes on; any other command ends it.
  void OnCommand(const sensor::ScanCommand& command, double time_s);
  void OnPtuState(const sensor::PtuState& state, double time_s);
  void OnBaseState(const sensor::BaseState& state, double time_s);
  void OnLaser(const device::LaserReport& report) { laser_ = report; }
  void OnFrame(const sensor::Image& grey, double start_s, double time_s);

  bool WantsFrame(double start_s, double time_s) const;
  sensor::Laser wanted_laser(double time_s) const;
  std::vector<sensor::Stripe> TakeAnswers();

 private:
  struct Waiting {
    sensor::Stripe stripe;
    int64_t middle_utime;
    double received_s;
  };
  bool BaseStands(double time_s) const;
  bool IsAsked(double time_s) const;
  bool TakePose(Waiting* frame) const;
  void AnswerWaiting(double time_s);

  StripeSweepOptions options_;
  std::optional<sensor::ScanCommand> request_;
  double last_request_s_ = 0.0;
  std::deque<sensor::PtuState> head_;
  double head_received_s_ = 0.0;
  std::optional<sensor::BaseState> base_;
  double base_received_s_ = 0.0;
  device::LaserReport laser_;
  double last_start_s_ = 0.0;
  std::deque<Waiting> waiting_;
  std::vector<sensor::Stripe> answers_;
};

}  // namespace geon::stripe_camera
