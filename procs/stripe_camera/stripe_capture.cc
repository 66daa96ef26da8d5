#include "procs/stripe_camera/stripe_capture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/angles.h"

namespace geon::stripe_camera {
namespace {

using sensor::DeviceStatus;
using sensor::Laser;
using sensor::StripeStatus;

constexpr size_t kAnswersKept = 16;
constexpr double kRepeatPeriod_s = 0.3;  // an answer is not repeated faster than that
// Standing still: less than a step of the pan-tilt unit (0.0514 deg) and of the odometry.
constexpr double kSameAngle_rad = RadiansFromDegrees(0.06);
constexpr double kSamePlace_m = 0.005;
constexpr double kNever_s = -std::numeric_limits<double>::infinity();

bool SameHead(const sensor::PtuState& a, const sensor::PtuState& b) {
  return std::abs(a.pan_rad - b.pan_rad) < kSameAngle_rad &&
         std::abs(a.tilt_rad - b.tilt_rad) < kSameAngle_rad;
}

bool SameKey(const sensor::Stripe& stripe, const sensor::ScanCommand& command) {
  return stripe.scan_id == command.scan_id && stripe.stripe_index == command.stripe_index &&
         stripe.attempt == command.attempt && stripe.laser == command.laser;
}

}  // namespace

StripeCapture::StripeCapture(const StripeCaptureOptions& options)
    : options_(options),
      sweep_({.exposure_s = options.exposure_s,
              .settle_s = options.settle_s,
              .state_timeout_s = options.state_timeout_s,
              .request_timeout_s = options.request_timeout_s,
              .proof = options.proof}) {}

Laser StripeCapture::needed_laser() const {
  return phase_ == Phase::kLit ? request_.laser : Laser::kNone;
}

Laser StripeCapture::wanted_laser(double time_s) const {
  return phase_ == Phase::kIdle ? sweep_.wanted_laser(time_s) : needed_laser();
}

std::vector<sensor::Stripe> StripeCapture::TakeAnswers() {
  std::vector<sensor::Stripe> answers = std::exchange(answers_, {});
  for (sensor::Stripe& swept : sweep_.TakeAnswers()) answers.push_back(std::move(swept));
  return answers;
}

void StripeCapture::OnCommand(const sensor::ScanCommand& command, double time_s) {
  sweep_.OnCommand(command, time_s);
  if (command.laser == Laser::kNone || command.stripe_index == sensor::kSweptStripe) {
    phase_ = Phase::kIdle;
    return;
  }
  const bool same = phase_ != Phase::kIdle && SameKey(stripe_, command);
  if (same) {
    last_request_s_ = time_s;
    return;
  }
  phase_ = Phase::kIdle;  // a new request replaces the old one
  if (AnswerFromMemory(command, time_s)) return;
  request_ = command;
  last_request_s_ = time_s;
  stripe_ = {};
  stripe_.scan_id = command.scan_id;
  stripe_.stripe_index = command.stripe_index;
  stripe_.attempt = command.attempt;
  stripe_.laser = command.laser;
  tries_ = 0;
  unlit_.Clear();
  lit_.Clear();
  last_start_s_ = kNever_s;
  Begin(Phase::kWaitStill, time_s);
  Tick(time_s);
}

bool StripeCapture::AnswerFromMemory(const sensor::ScanCommand& command, double time_s) {
  const auto answer = std::find_if(memory_.begin(), memory_.end(), [&](const Answer& candidate) {
    return SameKey(candidate.stripe, command);
  });
  if (answer == memory_.end()) return false;
  if (time_s - answer->answered_s >= kRepeatPeriod_s) {
    answer->answered_s = time_s;
    answers_.push_back(answer->stripe);
  }
  return true;
}

void StripeCapture::OnPtuState(const sensor::PtuState& state, double time_s) {
  const bool stands = state.status == DeviceStatus::kReady && !state.moving;
  if (!stands || !ptu_ || !SameHead(*ptu_, state)) ptu_still_since_s_ = time_s;
  ptu_ = state;
  ptu_received_s_ = time_s;
  sweep_.OnPtuState(state, time_s);
  Tick(time_s);
}

void StripeCapture::OnBaseState(const sensor::BaseState& state, double time_s) {
  base_ = state;
  base_received_s_ = time_s;
  sweep_.OnBaseState(state, time_s);
  Tick(time_s);
}

void StripeCapture::OnLaser(const device::LaserReport& report, double time_s) {
  const bool lost = phase_ == Phase::kLit && laser_.confirmed &&
                    (!report.confirmed || report.restarts != laser_.restarts);
  laser_ = report;
  sweep_.OnLaser(report);
  if (lost) lit_.Clear();  // what was lit before proves nothing for what comes
  Tick(time_s);
}

bool StripeCapture::IsLaser(Laser laser) const {
  return laser_.confirmed && laser_.laser == laser && laser_.status == DeviceStatus::kReady;
}

std::string StripeCapture::WhyNotStanding(double time_s) const {
  if (!ptu_ || time_s - ptu_received_s_ > options_.state_timeout_s) return "no fresh PTU_STATE";
  if (ptu_->status != DeviceStatus::kReady) return "the pan-tilt unit is not ready";
  if (ptu_->moving) return "the head moves";
  if (!base_) return "";  // a bench without a base
  if (time_s - base_received_s_ > options_.state_timeout_s) return "no fresh BASE_STATE";
  if (base_->status != DeviceStatus::kReady) return "the base is not ready";
  return base_->moving ? "the base moves" : "";
}

void StripeCapture::Begin(Phase phase, double time_s) {
  phase_ = phase;
  phase_since_s_ = time_s;
}

void StripeCapture::Tick(double time_s) {
  if (phase_ == Phase::kIdle) return;
  if (time_s - last_request_s_ > options_.request_timeout_s) {
    phase_ = Phase::kIdle;
    return;
  }
  const std::string why = WhyNotStanding(time_s);
  if (phase_ == Phase::kWaitStill) {
    if (why.empty() && time_s - ptu_still_since_s_ >= options_.still_s) {
      Begin(Phase::kUnlit, time_s);
    } else if (time_s - phase_since_s_ > options_.wait_still_s) {
      Refuse(StripeStatus::kMoving, why.empty() ? "the head has only just stopped" : why, time_s);
    }
    return;
  }
  if (!why.empty()) {
    Refuse(StripeStatus::kMoving, why, time_s);
  } else if (phase_ == Phase::kPose) {
    CheckPose(time_s);
  } else {
    CheckTimeouts(time_s);
  }
}

void StripeCapture::CheckTimeouts(double time_s) {
  const Laser needed = needed_laser();
  if (!IsLaser(needed)) {
    if (time_s - phase_since_s_ > options_.laser_timeout_s) {
      Refuse(StripeStatus::kLaserFault, "the laser board does not confirm: " + laser_.text, time_s);
    }
    return;
  }
  const double usable_since_s = std::max(phase_since_s_, laser_.confirmed_time_s);
  if (time_s - usable_since_s > options_.frame_timeout_s * (tries_ + 1)) {
    Refuse(StripeStatus::kCameraFault, "no frame began after the laser was confirmed", time_s);
  }
}

bool StripeCapture::WantsFrame(double start_s, double time_s) const {
  if (sweep_.WantsFrame(start_s, time_s)) return true;
  if (phase_ != Phase::kUnlit && phase_ != Phase::kLit) return false;
  const bool repeated = start_s <= last_start_s_;
  const bool early = !IsLaser(needed_laser()) ||
                     start_s < laser_.confirmed_time_s + options_.settle_s ||
                     start_s < ptu_still_since_s_ + options_.still_s;
  return !repeated && !early && start_s <= time_s;
}

void StripeCapture::OnFrame(const sensor::Image& grey, double start_s, double time_s) {
  Tick(time_s);
  if (!WantsFrame(start_s, time_s)) return;
  if (phase_ == Phase::kIdle) {
    sweep_.OnFrame(grey, start_s, time_s);
    return;
  }
  last_start_s_ = start_s;
  UseFrame(grey, start_s, time_s);
}

void StripeCapture::UseFrame(const sensor::Image& grey, double start_s, double time_s) {
  if (phase_ == Phase::kUnlit) {
    if (unlit_.count() == 0) {
      stripe_.unlit_utime = grey.utime;
      stripe_.pan_rad = ptu_->pan_rad;
      stripe_.tilt_rad = ptu_->tilt_rad;
      if (base_) {
        stripe_.x_m = base_->x_m;
        stripe_.y_m = base_->y_m;
        stripe_.heading_rad = base_->heading_rad;
      }
    }
    unlit_.Add(grey);
    if (unlit_.count() == options_.frames_per_stripe) Begin(Phase::kLit, time_s);
    return;
  }
  if (lit_.count() == 0) stripe_.lit_utime = grey.utime;
  lit_.Add(grey);
  lit_received_s_ = std::max(start_s, time_s);
  if (lit_.count() == options_.frames_per_stripe) JudgeLitFrames(time_s);
}

void StripeCapture::JudgeLitFrames(double time_s) {
  const std::vector<int16_t> difference = unlit_.MeanDifference(lit_);
  const StripeProof proof =
      ProveStripe(difference, lit_.width_px(), lit_.height_px(), request_.laser, options_.proof);
  stripe_.utime = stripe_.lit_utime;
  stripe_.lit_peak = proof.peak_level;
  stripe_.noise_level = proof.noise_level;
  stripe_.difference = SaturatedDifference(difference, lit_.width_px(), lit_.height_px());
  stripe_.difference.utime = stripe_.lit_utime;
  if (proof.lit) {
    Begin(Phase::kPose, time_s);
    return;
  }
  lit_.Clear();
  if (++tries_ < options_.lit_tries) return;
  Refuse(StripeStatus::kNotLit, proof.reason, time_s);
}

// A state of the head, measured after the lit exposure, that says the same as the one before the
// unlit one.
void StripeCapture::CheckPose(double time_s) {
  const bool head_known = ptu_received_s_ > lit_received_s_ && ptu_->utime >= stripe_.lit_utime;
  const bool base_known =
      !base_ || (base_received_s_ > lit_received_s_ && base_->utime >= stripe_.lit_utime);
  if (!head_known || !base_known) {
    if (time_s - phase_since_s_ > options_.state_timeout_s) {
      Refuse(StripeStatus::kMoving, "no state of head and base after the exposure", time_s);
    }
    return;
  }
  sensor::PtuState before;
  before.pan_rad = stripe_.pan_rad;
  before.tilt_rad = stripe_.tilt_rad;
  const bool same_place =
      !base_ || (std::hypot(base_->x_m - stripe_.x_m, base_->y_m - stripe_.y_m) < kSamePlace_m &&
                 std::abs(WrapAngle(base_->heading_rad - stripe_.heading_rad)) < kSameAngle_rad);
  if (!SameHead(before, *ptu_) || !same_place) {
    Refuse(StripeStatus::kMoving, "head or base moved between the frames", time_s);
    return;
  }
  Finish(StripeStatus::kLit, time_s);
}

void StripeCapture::Refuse(StripeStatus status, const std::string& why, double time_s) {
  reason_ = why;
  if (status != StripeStatus::kNotLit) stripe_.difference = {};
  Finish(status, time_s);
}

void StripeCapture::Finish(StripeStatus status, double time_s) {
  stripe_.status = status;
  answers_.push_back(stripe_);
  memory_.push_back({stripe_, time_s});
  if (memory_.size() > kAnswersKept) memory_.pop_front();
  phase_ = Phase::kIdle;
}

}  // namespace geon::stripe_camera
