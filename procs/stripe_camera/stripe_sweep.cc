#include "procs/stripe_camera/stripe_sweep.h"

#include <utility>

#include "base/time.h"

namespace geon::stripe_camera {
namespace {

using sensor::Laser;

// Where the head was at `utime`, between two of its states.
void Interpolate(const sensor::PtuState& before, const sensor::PtuState& after, int64_t utime,
                 sensor::Stripe* stripe) {
  const double whole_s = SecondsFromMicroseconds(after.utime - before.utime);
  const double part_1 =
      whole_s > 0.0 ? SecondsFromMicroseconds(utime - before.utime) / whole_s : 1.0;
  stripe->pan_rad = before.pan_rad + part_1 * (after.pan_rad - before.pan_rad);
  stripe->tilt_rad = before.tilt_rad + part_1 * (after.tilt_rad - before.tilt_rad);
}

}  // namespace

StripeSweep::StripeSweep(const StripeSweepOptions& options) : options_(options) {}

void StripeSweep::OnCommand(const sensor::ScanCommand& command, double time_s) {
  if (command.laser == Laser::kNone || command.stripe_index != sensor::kSweptStripe) {
    request_.reset();
    return;
  }
  request_ = command;
  last_request_s_ = time_s;
}

void StripeSweep::OnPtuState(const sensor::PtuState& state, double time_s) {
  head_received_s_ = time_s;
  if (state.status != sensor::DeviceStatus::kReady) {
    head_.clear();  // it may stand anywhere afterwards
    return;
  }
  if (!head_.empty() && state.utime <= head_.back().utime) return;
  head_.push_back(state);
  const int64_t kept_us = MicrosecondsFromSeconds(options_.history_s);
  while (state.utime - head_.front().utime > kept_us) head_.pop_front();
  AnswerWaiting(time_s);
}

void StripeSweep::OnBaseState(const sensor::BaseState& state, double time_s) {
  base_ = state;
  base_received_s_ = time_s;
}

bool StripeSweep::BaseStands(double time_s) const {
  if (!base_) return true;  // a bench without a base
  return time_s - base_received_s_ <= options_.state_timeout_s &&
         base_->status == sensor::DeviceStatus::kReady && !base_->moving;
}

bool StripeSweep::IsAsked(double time_s) const {
  return request_ && time_s - last_request_s_ <= options_.request_timeout_s && BaseStands(time_s) &&
         !head_.empty() && time_s - head_received_s_ <= options_.state_timeout_s;
}

Laser StripeSweep::wanted_laser(double time_s) const {
  return IsAsked(time_s) ? request_->laser : Laser::kNone;
}

bool StripeSweep::WantsFrame(double start_s, double time_s) const {
  return IsAsked(time_s) && laser_.confirmed && laser_.laser == request_->laser &&
         laser_.status == sensor::DeviceStatus::kReady && start_s > last_start_s_ &&
         start_s >= laser_.confirmed_time_s + options_.settle_s && start_s <= time_s;
}

void StripeSweep::OnFrame(const sensor::Image& grey, double start_s, double time_s) {
  if (!WantsFrame(start_s, time_s)) return;
  last_start_s_ = start_s;
  const std::vector<int16_t> levels = AboveMedian(grey);
  const StripeProof proof =
      ProveStripe(levels, grey.width_px, grey.height_px, request_->laser, options_.proof);
  if (!proof.lit) return;
  sensor::Stripe stripe;
  stripe.utime = stripe.lit_utime = stripe.unlit_utime = grey.utime;
  stripe.scan_id = request_->scan_id;
  stripe.stripe_index = sensor::kSweptStripe;
  stripe.attempt = request_->attempt;
  stripe.laser = request_->laser;
  stripe.status = sensor::StripeStatus::kLit;
  if (base_) {
    stripe.x_m = base_->x_m;
    stripe.y_m = base_->y_m;
    stripe.heading_rad = base_->heading_rad;
  }
  stripe.lit_peak = proof.peak_level;
  stripe.noise_level = proof.noise_level;
  stripe.difference = SaturatedDifference(levels, grey.width_px, grey.height_px);
  stripe.difference.utime = grey.utime;
  const double exposure_s = grey.exposure_s.value_or(options_.exposure_s);
  const int64_t middle_utime = grey.utime + MicrosecondsFromSeconds(0.5 * exposure_s);
  waiting_.push_back({std::move(stripe), middle_utime, time_s});
  AnswerWaiting(time_s);
}

bool StripeSweep::TakePose(Waiting* frame) const {
  for (size_t k = 1; k < head_.size(); ++k) {
    if (head_[k - 1].utime > frame->middle_utime || head_[k].utime < frame->middle_utime) continue;
    Interpolate(head_[k - 1], head_[k], frame->middle_utime, &frame->stripe);
    return true;
  }
  return false;
}

// In the order of the frames: one whose head state does not come holds nothing up for long.
void StripeSweep::AnswerWaiting(double time_s) {
  while (!waiting_.empty()) {
    Waiting& first = waiting_.front();
    if (TakePose(&first)) {
      answers_.push_back(std::move(first.stripe));
    } else if (time_s - first.received_s <= options_.history_s) {
      return;
    }
    waiting_.pop_front();
  }
}

std::vector<sensor::Stripe> StripeSweep::TakeAnswers() { return std::exchange(answers_, {}); }

}  // namespace geon::stripe_camera
