#include "procs/stripe_camera/stripe_capture.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace geon::stripe_camera {
namespace {

using sensor::DeviceStatus;
using sensor::Laser;
using sensor::StripeStatus;

constexpr double kTick_s = 0.005;

// A laser board that confirms 20 ms after it is asked, a camera of 20 frames a second whose frames
// arrive 30 ms after their exposure began, a head and a base that report 20 times a second: stepped
// together in virtual time, with faults to order.
class Bench {
 public:
  explicit Bench(const StripeCaptureOptions& options = {}) : capture(options) {
    ptu.status = DeviceStatus::kReady;
    ptu.pan_rad = 0.2;
    ptu.tilt_rad = -0.3;
    base.status = DeviceStatus::kReady;
    Run(1.0);  // everything stands and is known
  }

  void Run(double duration_s) {
    const double end_s = time_s + duration_s;
    while (time_s < end_s) Step();
  }
  // Repeats the request until it is answered.
  std::vector<sensor::Stripe> Ask(Laser laser, int32_t stripe_index = 0, double patience_s = 8.0) {
    const double end_s = time_s + patience_s;
    std::vector<sensor::Stripe> answers;
    while (answers.empty() && time_s < end_s) {
      capture.OnCommand(Command(laser, stripe_index), time_s);
      Run(0.1);
      answers = capture.TakeAnswers();
    }
    return answers;
  }
  static sensor::ScanCommand Command(Laser laser, int32_t stripe_index = 0) {
    sensor::ScanCommand command;
    command.scan_id = 5;
    command.stripe_index = stripe_index;
    command.attempt = 1;
    command.laser = laser;
    return command;
  }
  int64_t Utime(double at_s) const { return 1'000'000'000 + static_cast<int64_t>(at_s * 1e6); }

  StripeCapture capture;
  double time_s = 0.0;
  sensor::PtuState ptu;
  sensor::BaseState base;
  bool base_reports = true;
  bool ptu_reports = true;
  bool camera_works = true;
  bool board_answers = true;
  bool laser_is_dead = false;  // confirms, but nothing burns
  bool wrong_laser = false;    // confirms, but the other one burns
  double stamp_early_s = 0.0;  // frames say that they began so much later than they did
  bool frames_repeat = false;  // every frame is delivered twice
  double frame_delay_s = 0.03;
  Laser burning = Laser::kNone;
  double burned_s = 0.0;
  int both_states = 0;

 private:
  struct Frame {
    sensor::Image image;
    double start_s;
    double arrival_s;
  };

  void Step() {
    time_s += kTick_s;
    StepBoard();
    StepCamera();
    if (Due(0.05, &next_state_s_)) {
      ptu.utime = base.utime = Utime(time_s);
      if (ptu_reports) capture.OnPtuState(ptu, time_s);
      if (base_reports) capture.OnBaseState(base, time_s);
    }
    capture.Tick(time_s);
  }

  void StepBoard() {
    if (capture.wanted_laser(time_s) != asked_) {
      asked_ = capture.wanted_laser(time_s);
      asked_s_ = time_s;
      report_.confirmed = false;
      if (asked_ != Laser::kNone) report_.laser = asked_;  // may burn from now on
    }
    if (!report_.confirmed && board_answers && time_s - asked_s_ >= 0.02) {
      report_.confirmed = true;
      report_.confirmed_time_s = time_s;
      report_.status = DeviceStatus::kReady;
      report_.laser = asked_;
      burning = asked_;
    }
    if (burning != Laser::kNone) burned_s += kTick_s;
    capture.OnLaser(report_, time_s);
  }

  void StepCamera() {
    if (camera_works && Due(0.05, &next_frame_s_)) {
      Frame frame{Picture(), time_s, time_s + frame_delay_s};
      frame.image.seq = ++seq_;
      frame.image.utime = Utime(time_s);
      frames_.push_back(frame);
      if (frames_repeat) frames_.push_back(frame);
    }
    while (!frames_.empty() && frames_.front().arrival_s <= time_s) {
      const Frame frame = frames_.front();
      frames_.pop_front();
      capture.OnFrame(frame.image, frame.start_s + stamp_early_s, time_s);
    }
  }

  // What is seen now: a stripe of whatever burns.
  sensor::Image Picture() const {
    sensor::Image image;
    image.width_px = 64;
    image.height_px = 48;
    image.row_stride_bytes = 64;
    image.data.assign(64 * 48, 20);
    Laser seen = laser_is_dead ? Laser::kNone : burning;
    if (wrong_laser && seen != Laser::kNone) {
      seen = seen == Laser::kHorizontal ? Laser::kVertical : Laser::kHorizontal;
    }
    for (size_t i = 0; i < 64 && seen == Laser::kHorizontal; ++i) image.data[30 * 64 + i] = 220;
    for (size_t i = 0; i < 48 && seen == Laser::kVertical; ++i) image.data[i * 64 + 40] = 220;
    return image;
  }

  bool Due(double period_s, double* next_s) const {
    if (time_s + 1e-9 < *next_s) return false;
    *next_s += period_s;
    return true;
  }

  Laser asked_ = Laser::kNone;
  double asked_s_ = -1.0;
  device::LaserReport report_;
  double next_state_s_ = 0.0;
  double next_frame_s_ = 0.0;
  int32_t seq_ = 0;
  std::deque<Frame> frames_;
};

void ExpectStatus(const std::vector<sensor::Stripe>& answers, StripeStatus status,
                  const Bench& bench) {
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].status, status) << bench.capture.reason();
}

TEST(StripeCapture, ProvesAPairOfFrames) {
  Bench bench;
  const auto answers = bench.Ask(Laser::kHorizontal, 3);
  ExpectStatus(answers, StripeStatus::kLit, bench);
  const sensor::Stripe& stripe = answers[0];
  EXPECT_EQ(stripe.scan_id, 5);
  EXPECT_EQ(stripe.stripe_index, 3);
  EXPECT_EQ(stripe.attempt, 1);
  EXPECT_EQ(stripe.laser, Laser::kHorizontal);
  EXPECT_EQ(stripe.pan_rad, 0.2);
  EXPECT_EQ(stripe.tilt_rad, -0.3);
  EXPECT_LT(stripe.unlit_utime, stripe.lit_utime);
  EXPECT_EQ(stripe.utime, stripe.lit_utime);
  EXPECT_EQ(stripe.lit_peak, 200.0);
  EXPECT_EQ(stripe.noise_level, 0.0);
  ASSERT_EQ(stripe.difference.data.size(), 64u * 48u);
  EXPECT_EQ(stripe.difference.data[30 * 64 + 5], 200);
  EXPECT_EQ(stripe.difference.data[0], 0);
  bench.Run(0.1);
  EXPECT_EQ(bench.burning, Laser::kNone);
  ExpectStatus(bench.Ask(Laser::kVertical, 4), StripeStatus::kLit, bench);
}

TEST(StripeCapture, AveragesAsManyFramesAsAsked) {
  StripeCaptureOptions options;
  options.frames_per_stripe = 4;
  Bench bench(options);
  const auto answers = bench.Ask(Laser::kHorizontal);
  ExpectStatus(answers, StripeStatus::kLit, bench);
  EXPECT_GE(answers[0].lit_utime - answers[0].unlit_utime, 4 * 50'000);
}

TEST(StripeCapture, AFrameBegunBeforeTheConfirmationDoesNotCount) {
  Bench bench;
  bench.frame_delay_s = 0.3;  // many frames are under way when the laser comes on
  ExpectStatus(bench.Ask(Laser::kHorizontal), StripeStatus::kLit, bench);
}

TEST(StripeCapture, StampsThatLieAreFoundOutByThePixels) {
  Bench bench;
  bench.frame_delay_s = 0.3;
  bench.stamp_early_s = 0.25;  // frames from before "on" pass for lit ones: they show no stripe
  const auto answers = bench.Ask(Laser::kHorizontal);
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].status, StripeStatus::kNotLit);
}

TEST(StripeCapture, AFrameFromTheFutureDoesNotCount) {
  Bench bench;
  bench.stamp_early_s = 10.0;
  ExpectStatus(bench.Ask(Laser::kHorizontal, 0, 20.0), StripeStatus::kCameraFault, bench);
}

TEST(StripeCapture, ARepeatedFrameCountsOnce) {
  StripeCaptureOptions options;
  options.frames_per_stripe = 2;
  Bench bench(options);
  bench.frames_repeat = true;
  const auto answers = bench.Ask(Laser::kHorizontal);
  ExpectStatus(answers, StripeStatus::kLit, bench);
  EXPECT_GE(answers[0].lit_utime - answers[0].unlit_utime, 2 * 50'000);
}

TEST(StripeCapture, ALaserThatDoesNotBurnIsNotLit) {
  Bench bench;
  bench.laser_is_dead = true;
  const auto answers = bench.Ask(Laser::kHorizontal);
  ExpectStatus(answers, StripeStatus::kNotLit, bench);
  EXPECT_GE(answers[0].lit_utime - answers[0].unlit_utime, 3 * 50'000);  // looked three times
}

TEST(StripeCapture, TheOtherLaserIsNotLit) {
  Bench bench;
  bench.wrong_laser = true;
  ExpectStatus(bench.Ask(Laser::kHorizontal), StripeStatus::kNotLit, bench);
}

TEST(StripeCapture, ASilentBoardIsALaserFault) {
  Bench bench;
  bench.capture.OnCommand(Bench::Command(Laser::kHorizontal), bench.time_s);
  bench.board_answers = false;
  ExpectStatus(bench.Ask(Laser::kHorizontal), StripeStatus::kLaserFault, bench);
}

TEST(StripeCapture, ACameraThatStopsIsACameraFault) {
  Bench bench;
  bench.camera_works = false;
  ExpectStatus(bench.Ask(Laser::kHorizontal), StripeStatus::kCameraFault, bench);
  EXPECT_TRUE(bench.capture.TakeAnswers().empty());
}

TEST(StripeCapture, NothingBurnsWhileTheHeadMoves) {
  Bench bench;
  bench.ptu.moving = true;
  bench.Run(0.1);
  ExpectStatus(bench.Ask(Laser::kHorizontal), StripeStatus::kMoving, bench);
  EXPECT_EQ(bench.burned_s, 0.0);
}

TEST(StripeCapture, ARequestWaitsForTheHeadToStop) {
  Bench bench;
  bench.ptu.moving = true;
  bench.Run(0.1);
  bench.capture.OnCommand(Bench::Command(Laser::kHorizontal), bench.time_s);
  bench.Run(0.5);
  bench.ptu.moving = false;
  ExpectStatus(bench.Ask(Laser::kHorizontal), StripeStatus::kLit, bench);
}

TEST(StripeCapture, NothingBurnsWithoutAKnownHead) {
  Bench bench;
  bench.ptu_reports = false;
  bench.Run(1.5);
  ExpectStatus(bench.Ask(Laser::kHorizontal), StripeStatus::kMoving, bench);
  EXPECT_EQ(bench.burned_s, 0.0);
}

// Runs until the laser burns for one request.
void UntilItBurns(Bench* bench) {
  while (bench->burning == Laser::kNone && bench->time_s < 60.0) {
    bench->capture.OnCommand(Bench::Command(Laser::kHorizontal), bench->time_s);
    bench->Run(kTick_s);
  }
  ASSERT_EQ(bench->burning, Laser::kHorizontal);
}

TEST(StripeCapture, ABaseThatStartsToMoveDarkensTheLaserAtOnce) {
  Bench bench;
  bench.camera_works = false;  // it burns and waits
  bench.Run(1.0);
  bench.camera_works = true;
  UntilItBurns(&bench);
  bench.base.moving = true;
  bench.capture.OnBaseState(bench.base, bench.time_s);
  EXPECT_EQ(bench.capture.wanted_laser(bench.time_s), Laser::kNone);
  const auto answers = bench.capture.TakeAnswers();
  ExpectStatus(answers, StripeStatus::kMoving, bench);
}

TEST(StripeCapture, ABaseThatFallsSilentDarkensTheLaser) {
  Bench bench;
  UntilItBurns(&bench);
  bench.base_reports = false;
  bench.camera_works = false;
  for (int i = 0; i < 15; ++i) {
    bench.capture.OnCommand(Bench::Command(Laser::kHorizontal), bench.time_s);
    bench.Run(0.1);
  }
  EXPECT_EQ(bench.burning, Laser::kNone);
  EXPECT_LT(bench.burned_s, 1.2);
}

TEST(StripeCapture, AHeadThatMovedBetweenTheFramesIsFoundOut) {
  Bench bench;
  UntilItBurns(&bench);
  bench.ptu.pan_rad += 0.01;  // and says that it stands
  const auto answers = bench.Ask(Laser::kHorizontal);
  ExpectStatus(answers, StripeStatus::kMoving, bench);
}

TEST(StripeCapture, TheLaserGoesOutOneSecondAfterTheLastRequest) {
  Bench bench;
  UntilItBurns(&bench);
  bench.camera_works = false;
  const double asked_s = bench.time_s;
  while (bench.burning != Laser::kNone && bench.time_s < asked_s + 5.0) bench.Run(kTick_s);
  EXPECT_LE(bench.time_s - asked_s, 1.0 + 0.02 + 3 * kTick_s);
  bench.Run(3.0);
  EXPECT_TRUE(bench.capture.TakeAnswers().empty());
}

TEST(StripeCapture, LaserNoneSwitchesOffAndForgets) {
  Bench bench;
  UntilItBurns(&bench);
  bench.capture.OnCommand(Bench::Command(Laser::kNone), bench.time_s);
  EXPECT_EQ(bench.capture.wanted_laser(bench.time_s), Laser::kNone);
  bench.Run(0.5);
  EXPECT_EQ(bench.burning, Laser::kNone);
  EXPECT_TRUE(bench.capture.TakeAnswers().empty());
}

TEST(StripeCapture, ARepeatedRequestIsAnsweredFromMemory) {
  Bench bench;
  const auto first = bench.Ask(Laser::kHorizontal, 1);
  ExpectStatus(first, StripeStatus::kLit, bench);
  bench.Run(0.5);
  const double burned_s = bench.burned_s;
  const auto again = bench.Ask(Laser::kHorizontal, 1);
  ExpectStatus(again, StripeStatus::kLit, bench);
  EXPECT_EQ(again[0].lit_utime, first[0].lit_utime);
  EXPECT_EQ(again[0].difference.data, first[0].difference.data);
  EXPECT_EQ(bench.burned_s, burned_s);
}

TEST(StripeCapture, ANewRequestReplacesTheOldOne) {
  Bench bench;
  UntilItBurns(&bench);
  bench.capture.OnCommand(Bench::Command(Laser::kVertical, 1), bench.time_s);
  EXPECT_EQ(bench.capture.wanted_laser(bench.time_s), Laser::kNone);
  const auto answers = bench.Ask(Laser::kVertical, 1);
  ExpectStatus(answers, StripeStatus::kLit, bench);
  EXPECT_EQ(answers[0].stripe_index, 1);
}

TEST(StripeCapture, ABoardThatRestartsIsAskedAgain) {
  Bench bench;
  UntilItBurns(&bench);
  device::LaserReport restarted;  // unconfirmed: a restarted board is dark
  restarted.status = DeviceStatus::kStarting;
  restarted.restarts = 1;
  bench.capture.OnLaser(restarted, bench.time_s);
  ExpectStatus(bench.Ask(Laser::kHorizontal), StripeStatus::kLit, bench);
}

}  // namespace
}  // namespace geon::stripe_camera
