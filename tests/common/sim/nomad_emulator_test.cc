#include "sim/nomad_emulator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/sim/device_testing.h"

namespace geon::sim {
namespace {

using ::testing::SizeIs;

constexpr double kInch_m = 0.0254;

// A base and a host that knows the frames.
class NomadEmulatorTest : public ::testing::Test {
 protected:
  explicit NomadEmulatorTest(std::vector<Walls::Wall> walls = {})
      : world_(std::move(walls)), base_(Options(), &world_), host_(&base_) {}

  static NomadEmulatorOptions Options() {
    NomadEmulatorOptions options;
    SonarRingOptions& sonar = options.sonar;
    sonar.fading_1 = sonar.deaf_probability_1 = sonar.specular_probability_1 =
        sonar.crosstalk_probability_1 = sonar.multiple_echo_probability_1 = 0.0;
    return options;
  }
  std::vector<NomadFrame> Hear(double duration_s) {
    std::vector<NomadFrame> frames;
    for (const uint8_t byte : host_.Listen(duration_s)) {
      for (NomadFrame& frame : hearing_.Push(byte)) frames.push_back(std::move(frame));
    }
    return frames;
  }
  std::vector<NomadFrame> Ask(const std::vector<uint8_t>& bytes, double duration_s = 0.05) {
    host_.Send(bytes);
    return Hear(duration_s);
  }
  std::vector<NomadFrame> Ask(NomadType type, std::vector<uint8_t> payload = {},
                              double duration_s = 0.05) {
    return Ask(EncodeNomadFrame({static_cast<uint8_t>(type), std::move(payload)}), duration_s);
  }
  static std::vector<uint8_t> Signed(std::vector<int> values) {
    std::vector<uint8_t> payload;
    for (const int value : values) AppendNomadSigned(value, &payload);
    return payload;
  }
  // Command and a wait, with the dead-man off.
  void Drive(int translation, int steering, int turret, double duration_s) {
    Ask(NomadType::kVelocity, Signed({translation, steering, turret}), duration_s);
  }
  // x, y, steering, turret in tenths.
  std::array<int, 4> Configuration() {
    const auto frames = Ask(NomadType::kGetConfiguration);
    std::array<int, 4> values{};
    for (size_t i = 0; i < 4; ++i) values[i] = NomadSigned(frames.at(0).payload, 2 * i);
    return values;
  }
  uint32_t Bumpers() {
    const auto payload = Ask(NomadType::kGetBumper).at(0).payload;
    return static_cast<uint32_t>((payload.at(0) << 16) | (payload.at(1) << 8) | payload.at(2));
  }

  Walls world_;
  NomadEmulator base_;
  TestHost host_;
  NomadFrameReader hearing_;
};

class NomadAtAWallTest : public NomadEmulatorTest {
 protected:
  NomadAtAWallTest() : NomadEmulatorTest({{{-1.0, 0.0}, -0.6}}) {}
};

TEST_F(NomadEmulatorTest, UnderstandsTheVendorClientsFrames) {
  const std::vector<std::vector<uint8_t>> golden = {
      {0x01, 0x02, 0x00, 0x07, 0x0a, 0x5c},
      {0x01, 0x09, 0x00, 0x06, 0xff, 0xff, 0xff, 0xff, 0xff, 0x01, 0x01, 0x0d, 0x5c},
      {0x01, 0x08, 0x00, 0x02, 0xc8, 0x00, 0xc2, 0x01, 0xc2, 0x01, 0x59, 0x5c},
      {0x01, 0x08, 0x00, 0x01, 0x2c, 0x01, 0x2c, 0x01, 0x2c, 0x01, 0x91, 0x5c},
      {0x01, 0x08, 0x00, 0x05, 0x64, 0x00, 0x32, 0x80, 0x00, 0x00, 0x24, 0x5c},
      {0x01, 0x03, 0x00, 0x12, 0x05, 0x1b, 0x5c},
      {0x01, 0x13, 0x00, 0x0f, 0x0f, 0x00, 0x02, 0x0f, 0x01, 0x0e, 0x03, 0x0d,
       0x04, 0x0c, 0x05, 0x0b, 0x06, 0x0a, 0x07, 0x09, 0x08, 0xaa, 0x5c},
      {0x01, 0x02, 0x00, 0x14, 0x17, 0x5c},
      {0x01, 0x02, 0x00, 0x1b, 0x1e, 0x5c},
      {0x01, 0x02, 0x00, 0x15, 0x18, 0x5c},
      {0x01, 0x02, 0x00, 0x09, 0x0c, 0x5c},
  };
  for (const auto& bytes : golden) {
    const auto frames = Ask(bytes);
    ASSERT_EQ(frames.size(), 1u) << "type " << int{bytes[3]};
    EXPECT_EQ(frames[0].type, bytes[3]);
  }
  const auto zeroed = Ask({0x01, 0x02, 0x00, 0x0d, 0x10, 0x5c}, 10.0);
  ASSERT_EQ(zeroed.size(), 1u);
  EXPECT_EQ(zeroed[0].type, 0x0d);
}

TEST_F(NomadEmulatorTest, TheFullStateTakes58BytesAtTheLinesSpeed) {
  Ask(NomadType::kMask, {0xff, 0xff, 0xff, 0xff, 0xff, 0x01, 0x01});
  host_.Send(EncodeNomadFrame({7, {}}));
  // 6 bytes there, the reply's latency, 58 back: 1.6 + 3 + 15.1 ms.
  EXPECT_LT(host_.Listen(0.019).size(), 58u);
  Ask(NomadType::kGetState);
  host_.Send(EncodeNomadFrame({7, {}}));
  EXPECT_EQ(host_.Listen(0.025).size(), 58u);
}

TEST_F(NomadEmulatorTest, DrivesAtTheVelocityAskedForAndCountsIt) {
  Drive(100, 0, 0, 2.0);
  const auto velocity = Ask(NomadType::kGetVelocity).at(0).payload;
  EXPECT_EQ(NomadSigned(velocity, 0), 100);
  EXPECT_NEAR(base_.drive().true_speed_m_s(), 0.254, 1e-6);
  Ask(NomadType::kStop, {}, 1.0);
  EXPECT_NEAR(Configuration()[0] * 0.1 * kInch_m, base_.drive().center_W_m().x(), 0.002);
  EXPECT_GT(base_.drive().center_W_m().x(), 0.4);
}

TEST_F(NomadEmulatorTest, ClampsToItsOwnSpeeds) {
  Drive(3000, -3000, -3000, 3.0);
  const auto velocity = Ask(NomadType::kGetVelocity).at(0).payload;
  EXPECT_EQ(NomadSigned(velocity, 0), 200);
  EXPECT_EQ(NomadSigned(velocity, 2), -600);
  EXPECT_EQ(NomadSigned(velocity, 4), -600);
}

TEST_F(NomadEmulatorTest, TheTurretFollowsUnlessItHasAMotionOfItsOwn) {
  Drive(0, 300, 0, 2.0);
  Ask(NomadType::kStop, {}, 1.0);
  auto angles = Configuration();
  EXPECT_GT(angles[2], 300);
  EXPECT_EQ(angles[2], angles[3]);
  Ask(NomadType::kMoveRelative, Signed({0, 0, -450}), 3.0);
  const auto turned = Configuration();
  EXPECT_EQ(turned[2], angles[2]);
  EXPECT_EQ(turned[3], angles[3] - 450);
}

TEST(NomadEmulator, ATurretOfItsOwnStaysWhenNotAsked) {
  const FreeSpace world;
  NomadEmulatorOptions options;
  options.turret_follows_steering = false;
  NomadEmulator base(options, &world);
  TestHost host(&base);
  std::vector<uint8_t> payload;
  for (const int value : {0, 300, 0}) AppendNomadSigned(value, &payload);
  host.Send(EncodeNomadFrame({5, payload}));
  host.Listen(2.0);
  EXPECT_GT(base.drive().heading_W_rad(), 0.3);
  EXPECT_EQ(base.drive().turret_W_rad(), 0.0);
}

TEST_F(NomadEmulatorTest, MovesByAndToDistances) {
  Ask(NomadType::kSpeed, Signed({200, 450, 450}));
  Ask(NomadType::kMoveRelative, Signed({-100, 900, 900}), 5.0);
  EXPECT_NEAR(base_.drive().heading_W_rad(), kPi / 2, 1e-3);
  Ask(NomadType::kMoveAbsolute, Signed({0, 0, 0}), 8.0);
  EXPECT_NEAR(base_.drive().heading_W_rad(), 0.0, 1e-3);
  EXPECT_NEAR(base_.drive().position(Servo::kTranslation), 0.0, 1e-6);
}

TEST_F(NomadEmulatorTest, DrivesEachServoItsOwnWay) {
  std::vector<uint8_t> payload;
  const auto servo = [&](int mode, int value) {
    AppendNomadUnsigned(mode, &payload);
    AppendNomadSigned(value, &payload);
  };
  servo(1, 50);   // VM
  servo(2, 450);  // PR
  servo(0, 0);    // ignore
  EXPECT_EQ(Ask(NomadType::kMoveServos, payload, 4.0).at(0).type, 43);
  EXPECT_NEAR(base_.drive().velocity(Servo::kTranslation), 50 * 0.00254, 1e-6);
  EXPECT_NEAR(base_.drive().position(Servo::kSteering), kPi / 4, 1e-6);
  payload.clear();
  servo(7, 1);  // torque: this robot has no such control
  servo(0, 0);
  servo(0, 0);
  EXPECT_EQ(Ask(NomadType::kMoveServos, payload).at(0).type, 8);
}

TEST_F(NomadEmulatorTest, AccelerationsAreKeptAndTold) {
  Ask(NomadType::kAcceleration, Signed({100, 200, 300}));
  const auto payload = Ask(NomadType::kGetAcceleration).at(0).payload;
  EXPECT_EQ(NomadUnsigned(payload, 0), 100);
  EXPECT_EQ(NomadUnsigned(payload, 2), 200);
  EXPECT_EQ(NomadUnsigned(payload, 4), 300);
}

TEST_F(NomadEmulatorTest, StopsWhenTheHostFallsSilent) {
  Ask(NomadType::kConfigureTimeout, {1});
  Drive(150, 0, 0, 0.9);
  for (int i = 0; i < 5; ++i) Ask(NomadType::kGetState, {}, 0.9);  // any command keeps it going
  EXPECT_NEAR(base_.drive().true_speed_m_s(), 0.381, 1e-6);
  host_.Listen(0.5);
  EXPECT_EQ(base_.drive().true_speed_m_s(), 0.0);
}

TEST_F(NomadEmulatorTest, WithoutATimeoutItDrivesOn) {
  Drive(50, 0, 0, 20.0);
  EXPECT_GT(base_.drive().true_speed_m_s(), 0.1);
}

TEST_F(NomadEmulatorTest, WaitsForTheEndOfAMotionBeforeItAnswers) {
  Ask(NomadType::kSpeed, Signed({200, 450, 450}));
  Ask(NomadType::kMoveRelative, Signed({200, 0, 0}));
  EXPECT_THAT(Ask(NomadType::kWaitStop, {1, 0, 0, 30}, 0.8), SizeIs(0));
  EXPECT_THAT(Hear(2.0), SizeIs(1));
  EXPECT_NEAR(base_.drive().odometry_m().x(), 20 * kInch_m, 1e-3);
  // And no longer than it is told to.
  Drive(50, 0, 0, 0.1);
  EXPECT_THAT(Ask(NomadType::kWaitStop, {1, 1, 1, 1}, 0.9), SizeIs(0));
  EXPECT_THAT(Hear(0.3), SizeIs(1));
}

TEST_F(NomadEmulatorTest, ANewCommandEndsAWaitWithoutLosingAReply) {
  Drive(50, 0, 0, 0.1);
  EXPECT_THAT(Ask(NomadType::kWaitStop, {1, 1, 1, 100}, 0.5), SizeIs(0));
  const auto frames = Ask(NomadType::kStop, {}, 0.5);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].type, 31);
  EXPECT_EQ(frames[1].type, 9);
  EXPECT_EQ(base_.drive().true_speed_m_s(), 0.0);
}

TEST_F(NomadEmulatorTest, ZeroingAlignsWheelsAndTurretWithTheBase) {
  Ask(NomadType::kMoveRelative, Signed({100, 700, 300}), 5.0);
  EXPECT_THAT(Ask(NomadType::kZero, {}, 10.0), SizeIs(1));
  EXPECT_EQ(Configuration(), (std::array<int, 4>{0, 0, 0, 0}));
  EXPECT_NEAR(base_.drive().heading_W_rad(), 0.0, 1e-9);
  EXPECT_NEAR(base_.drive().turret_W_rad(), 0.0, 1e-9);
}

TEST_F(NomadEmulatorTest, PositionAndAnglesCanBeDefined) {
  Ask(NomadType::kDefinePosition, Signed({1234, -567}));
  Ask(NomadType::kDefineAngles, Signed({450, -450}));
  EXPECT_EQ(Configuration(), (std::array<int, 4>{1234, -567, 450, -450}));
  Ask(NomadType::kMoveRelative, Signed({100, 0, 0}), 3.0);
  const auto moved = Configuration();
  EXPECT_NEAR(moved[0], 1234 + 71, 2);
  EXPECT_NEAR(moved[1], -567 + 71, 2);
}

TEST_F(NomadEmulatorTest, TheStateCarriesMotionClockAndVolts) {
  Drive(50, 0, 0, 1.0);
  const auto payload = Ask(NomadType::kGetState).at(0).payload;
  ASSERT_EQ(payload.size(), 7u) << "no mask yet";
  EXPECT_EQ(payload[0], 1);
  const double time_ms = payload[1] | (payload[2] << 8);
  EXPECT_NEAR(time_ms, 1000.0, 70.0);
  EXPECT_LT(std::fmod(time_ms + 0.999, 16.4), 1.0) << "a tick is 16.4 ms";
  EXPECT_NEAR((2.0 + 3.0 * payload[6] / 255.0) * 12.85 / 5.0, 12.1, 0.03);
}

TEST_F(NomadEmulatorTest, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(Ask({0x01, 0x02, 0x00, 0x63, 0x66, 0x5c}).at(0).type, 8);
  EXPECT_EQ(Ask(NomadType::kVelocity, {1, 2}).at(0).type, 8) << "payload too short";
  EXPECT_EQ(Ask({0x01, 0x02, 0x00, 0x07, 0x0b, 0x5c}).at(0).type, 8) << "checksum";
}

TEST_F(NomadEmulatorTest, APowerCycleForgetsMaskTimeoutAndPosition) {
  Ask(NomadType::kMask, {0, 0, 0, 0, 0xff, 0, 0});
  Ask(NomadType::kConfigureTimeout, {1});
  Drive(100, 0, 0, 0.9);
  base_.PowerCycle(host_.now_s());
  const auto payload = Ask(NomadType::kGetState).at(0).payload;
  ASSERT_EQ(payload.size(), 7u);
  EXPECT_LT(payload[1] | (payload[2] << 8), 100) << "the clock starts again";
  EXPECT_EQ(Configuration()[0], 0);
  Drive(50, 0, 0, 3.0);
  EXPECT_GT(base_.drive().true_speed_m_s(), 0.0) << "no dead-man any more";
}

TEST_F(NomadAtAWallTest, FeelsSeesAndHearsTheWall) {
  host_.Listen(1.1);
  auto sonar = Ask(NomadType::kGetSonar).at(0).payload;
  ASSERT_EQ(sonar.size(), 20u);
  EXPECT_LE(sonar[0], 20) << "0.375 m: at or inside the blanking distance";
  EXPECT_EQ(sonar[8], 255);
  EXPECT_EQ(Bumpers(), 0u);
  Drive(100, 0, 0, 3.0);
  EXPECT_EQ(Bumpers(), 1u);
  EXPECT_TRUE(base_.bumper_pressed());
  EXPECT_EQ(base_.drive().true_speed_m_s(), 0.0);
  const auto infrared = Ask(NomadType::kGetInfrared).at(0).payload;
  ASSERT_EQ(infrared.size(), 12u);
  EXPECT_GE(infrared[0] & 0x0f, 12);
}

TEST_F(NomadAtAWallTest, TheBumperThatTouchesDependsOnTheBaseNotOnTheWheels) {
  Ask(NomadType::kMoveRelative, Signed({0, 1800, 1800}), 6.0);
  Drive(-100, 0, 0, 3.0);  // backwards into the wall that was ahead
  EXPECT_EQ(Bumpers(), 1u);
}

TEST_F(NomadAtAWallTest, EachSonarIsAsOldAsItsTurn) {
  Ask(NomadType::kConfigureSonar, {250, 0, 1, 255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 1.5);
  const int before = Ask(NomadType::kGetSonar).at(0).payload[0];
  Drive(-200, 0, 0, 0.3);  // the next ping of sensor 0 is a good while off
  EXPECT_EQ(Ask(NomadType::kGetSonar).at(0).payload[0], before);
  Drive(-200, 0, 0, 2.0);
  EXPECT_GT(Ask(NomadType::kGetSonar).at(0).payload[0], before + 10);
}

// A wall that ends between the heights of a sonar that is lowered by a tilt and one that is not.
class LowWall : public Walls {
 public:
  LowWall() : Walls({{{-1.0, 0.0}, -1.5}}) {}
  std::optional<RayHit> CastRay(const Eigen::Vector3d& origin_W_m,
                                const Eigen::Vector3d& direction_W, double reach_m) const override {
    const auto hit = Walls::CastRay(origin_W_m, direction_W, reach_m);
    if (!hit || (origin_W_m + hit->distance_m * direction_W).z() > 0.546) return std::nullopt;
    return hit;
  }
};

TEST_F(NomadEmulatorTest, ItsRingsTiltWithARobotWhoseWheelStandsInAGroove) {
  const LowWall world;
  NomadEmulatorOptions options = Options();
  options.sonar.echo.scatter_1 = 0.0;  // no edges
  const auto ahead_in = [&](double tilt_rad) {
    options.drive.grooves = {0.6, tilt_rad};
    options.drive.x_m = 0.6 - 0.19;  // the first wheel in the groove at 0.6 m
    options.drive.y_m = 0.3;
    NomadEmulator base(options, &world);
    TestHost host(&base);
    host.Send(EncodeNomadFrame({static_cast<uint8_t>(NomadType::kGetSonar), {}}));
    host.Listen(1.1);
    host.Send(EncodeNomadFrame({static_cast<uint8_t>(NomadType::kGetSonar), {}}));
    NomadFrameReader reader;
    int reading = -1;
    for (const uint8_t byte : host.Listen(0.1)) {
      for (const NomadFrame& frame : reader.Push(byte)) reading = frame.payload.at(0);
    }
    return reading;
  };
  EXPECT_EQ(ahead_in(0.0), SonarRing::kNoEcho_in) << "above the wall";
  EXPECT_NEAR(ahead_in(RadiansFromDegrees(2.0)), (1.5 - 0.41 - 0.225) / 0.0254, 3.0);
}

TEST_F(NomadEmulatorTest, AnyNoiseLeavesItAnsweringInStep) {
  NoiseSource noise(2024);
  for (int i = 0; i < 10000; ++i) {
    std::vector<uint8_t> bytes(noise.Bits() % 24);
    for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(noise.Bits());
    if (noise.Chance(0.3) && !bytes.empty()) bytes[0] = 0x01;
    host_.Send(bytes);
    host_.Listen(0.15);
    hearing_.Reset();
    const auto frames = Ask(NomadType::kGetState, {}, 0.03);
    ASSERT_EQ(frames.size(), 1u) << "string " << i;
    ASSERT_EQ(frames[0].type, 7) << "string " << i;
  }
}

TEST_F(NomadEmulatorTest, TheSameBytesAtTheSameTimesGiveTheSameReplies) {
  NomadEmulator other(Options(), &world_);
  const auto run = [](NomadEmulator* base, double poll_s) {
    std::vector<uint8_t> all;
    base->Receive(EncodeNomadFrame({6, {0xff, 0xff, 0xff, 0xff, 0xff, 1, 1}}), 0.0101);
    for (double t_s = 0.0; t_s < 1.0; t_s += poll_s) {
      base->Advance(t_s);
      const auto bytes = base->Transmit(t_s);
      all.insert(all.end(), bytes.begin(), bytes.end());
    }
    return all;
  };
  const auto fine = run(&base_, 0.001);
  EXPECT_EQ(fine, run(&other, 0.05)) << "however often it is polled";
  EXPECT_EQ(fine.size(), 58u);
}

}  // namespace
}  // namespace geon::sim
