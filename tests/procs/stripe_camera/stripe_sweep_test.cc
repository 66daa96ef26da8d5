#include "procs/stripe_camera/stripe_sweep.h"

#include <gtest/gtest.h>

#include "base/time.h"

namespace geon::stripe_camera {
namespace {

using sensor::DeviceStatus;
using sensor::Laser;

// A head that turns at 0.2 rad/s and says so 20 times a second, 30 ms late; a camera of 100 frames
// a second with an exposure of 8 ms, 20 ms late; a board that confirms after 20 ms. In virtual
// time.
class SweepBench {
 public:
  SweepBench() { Run(0.2); }
  void Run(double duration_s) {
    for (const double end_s = time_s + duration_s; time_s < end_s;) Step();
  }
  void Ask(Laser laser, int32_t stripe_index = sensor::kSweptStripe) {
    sensor::ScanCommand command;
    command.scan_id = 5;
    command.stripe_index = stripe_index;
    command.laser = laser;
    sweep.OnCommand(command, time_s);
  }
  std::vector<sensor::Stripe> TakeAll() {
    std::vector<sensor::Stripe> all = std::move(answers_);
    answers_.clear();
    return all;
  }
  static double PanAt(double at_s) { return 0.2 * at_s; }

  StripeSweep sweep;
  double time_s = 0.0;
  bool base_moves = false;
  bool shows_stripe = true;
  bool head_reports = true;
  double burned_s = 0.0;

 private:
  static int64_t Utime(double at_s) { return 1'000'000'000 + MicrosecondsFromSeconds(at_s); }
  void Step() {
    time_s += 0.005;
    ++step_;
    if (sweep.wanted_laser(time_s) != asked_) {
      asked_ = sweep.wanted_laser(time_s);
      asked_s_ = time_s;
    }
    device::LaserReport report;
    report.status = DeviceStatus::kReady;
    report.laser = asked_;
    report.confirmed = time_s - asked_s_ >= 0.02;
    report.confirmed_time_s = asked_s_ + 0.02;
    sweep.OnLaser(report);
    if (asked_ != Laser::kNone) burned_s += 0.005;
    if (step_ % 10 == 0) TellStates();
    if (step_ % 2 == 0) TellFrame();
    for (sensor::Stripe& stripe : sweep.TakeAnswers()) answers_.push_back(std::move(stripe));
  }
  void TellStates() {
    sensor::PtuState head;
    head.utime = Utime(time_s - 0.03);
    head.status = DeviceStatus::kReady;
    head.pan_rad = PanAt(time_s - 0.03);
    head.moving = true;
    if (head_reports) sweep.OnPtuState(head, time_s);
    sensor::BaseState base;
    base.status = DeviceStatus::kReady;
    base.moving = base_moves;
    sweep.OnBaseState(base, time_s);
  }
  void TellFrame() {
    const double start_s = time_s - 0.02;
    sensor::Image image;
    image.utime = Utime(start_s);
    image.width_px = 64;
    image.height_px = 48;
    image.row_stride_bytes = 64;
    image.data.assign(64 * 48, 20);
    for (size_t i = 0; i < 48 && shows_stripe && asked_ != Laser::kNone; ++i) {
      image.data[i * 64 + 40] = 220;
    }
    sweep.OnFrame(image, start_s, time_s);
  }

  int step_ = 0;
  Laser asked_ = Laser::kNone;
  double asked_s_ = -1.0;
  std::vector<sensor::Stripe> answers_;
};

TEST(StripeSweep, EveryLitFrameIsAStripeWithThePoseOfItsMiddle) {
  SweepBench bench;
  bench.Ask(Laser::kVertical);
  bench.Run(0.6);
  const std::vector<sensor::Stripe> stripes = bench.TakeAll();
  ASSERT_GE(stripes.size(), 40U);
  for (const sensor::Stripe& stripe : stripes) {
    const double middle_s = SecondsFromMicroseconds(stripe.lit_utime - 1'000'000'000) + 0.004;
    EXPECT_NEAR(stripe.pan_rad, SweepBench::PanAt(middle_s), 1e-6);
    EXPECT_EQ(stripe.stripe_index, sensor::kSweptStripe);
    EXPECT_EQ(stripe.scan_id, 5);
    EXPECT_EQ(stripe.laser, Laser::kVertical);
    EXPECT_EQ(stripe.lit_peak, 200.0);
    EXPECT_EQ(stripe.difference.data[40], 200);
    EXPECT_EQ(stripe.difference.data[0], 0);
  }
}

TEST(StripeSweep, BurnsOnlyWhileItIsAskedFor) {
  SweepBench bench;
  bench.Run(0.5);
  EXPECT_EQ(bench.burned_s, 0.0);
  bench.Ask(Laser::kVertical);
  bench.Run(3.0);
  EXPECT_NEAR(bench.burned_s, 1.0, 0.02);
  bench.Ask(Laser::kVertical);
  bench.Run(0.3);
  bench.Ask(Laser::kHorizontal, 2);  // a stripe that the head stops for
  bench.Run(0.5);
  EXPECT_NEAR(bench.burned_s, 1.3, 0.02);
}

TEST(StripeSweep, NothingBurnsWhileTheBaseMovesOrTheHeadIsSilent) {
  SweepBench bench;
  bench.base_moves = true;
  bench.Run(0.1);
  bench.Ask(Laser::kVertical);
  bench.Run(0.5);
  EXPECT_EQ(bench.burned_s, 0.0);
  EXPECT_TRUE(bench.TakeAll().empty());
  SweepBench silent;
  silent.head_reports = false;
  silent.Run(1.5);
  silent.Ask(Laser::kVertical);
  silent.Run(0.5);
  EXPECT_EQ(silent.burned_s, 0.0);
  EXPECT_TRUE(silent.TakeAll().empty());
}

TEST(StripeSweep, AFrameWithoutAStripeOrWithoutAPoseIsNone) {
  SweepBench bench;
  bench.shows_stripe = false;
  bench.Ask(Laser::kVertical);
  bench.Run(0.5);
  EXPECT_TRUE(bench.TakeAll().empty());
  bench.shows_stripe = true;
  bench.Run(0.2);
  bench.TakeAll();
  bench.head_reports = false;
  bench.Ask(Laser::kVertical);
  bench.Run(0.9);
  EXPECT_LE(bench.TakeAll().size(), 8U);  // of before
}

}  // namespace
}  // namespace geon::stripe_camera
