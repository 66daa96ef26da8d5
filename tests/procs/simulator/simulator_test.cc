#include "procs/simulator/simulator.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <zmq.hpp>

#include "base/angles.h"
#include "sim/random_world.h"

namespace geon::simulator {
namespace {

// A simulator that runs in a thread for the length of a test.
class SimulatorTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = "/tmp/geon-simulator-XXXXXX";
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    run_directory_ = pattern;
    SimulatorSettings settings;
    settings.world = sim::RandomWorld(1, sim::GeonPlace::kFloor);
    settings.rig.X_RP =
        geometry::MakeTransform(geometry::RotationAboutY(RadiansFromDegrees(15)), {0, 0, 1.2});
    settings.rig.X_TC = settings.rig.X_TB =
        geometry::MakeTransform(geometry::CameraAxesInBody(), Eigen::Vector3d::Zero());
    settings.rig.X_RF = settings.rig.X_RP * settings.rig.X_TC;
    settings.run_directory = run_directory_;
    settings.truth_file = run_directory_ / "truth.jsonl";
    auto simulator = Simulator::Open(settings);
    ASSERT_TRUE(simulator.ok()) << simulator.message();
    simulator_ = std::move(*simulator);
    thread_ = std::thread([this] { simulator_->Run(stop_); });
  }
  void StopSimulator() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    simulator_.reset();
  }
  void TearDown() override {
    StopSimulator();
    std::filesystem::remove_all(run_directory_);
  }

  std::filesystem::path run_directory_;
  std::unique_ptr<Simulator> simulator_;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

// What the device says until `end` has come, or ten seconds are over.
std::string Ask(const std::filesystem::path& device, const std::string& question,
                const std::string& end) {
  const int fd = open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
  EXPECT_GE(fd, 0) << device;
  termios settings{};
  tcgetattr(fd, &settings);
  cfmakeraw(&settings);
  cfsetspeed(&settings, B9600);
  tcsetattr(fd, TCSANOW, &settings);
  std::string answer;
  EXPECT_EQ(write(fd, question.data(), question.size()), static_cast<ssize_t>(question.size()));
  for (int tries = 0; tries < 100 && answer.find(end) == std::string::npos; ++tries) {
    pollfd wait{fd, POLLIN, 0};
    poll(&wait, 1, 100);
    char bytes[256];
    const ssize_t count = read(fd, bytes, sizeof bytes);
    if (count > 0) answer.append(bytes, static_cast<size_t>(count));
  }
  close(fd);
  return answer;
}

TEST_F(SimulatorTest, PtuAnswersOnItsPort) {
  EXPECT_NE(Ask(run_directory_ / "ptu.tty", "PP ", "is 0").find("Current Pan position is 0"),
            std::string::npos);
}

TEST_F(SimulatorTest, FramesComeInTwoPartsToThoseWhoSubscribe) {
  zmq::context_t context(1);
  const struct {
    const char* name;
    int width, height, channels;
  } cameras[] = {
      {"head_color", 640, 480, 3}, {"head_bw", 640, 480, 1}, {"floor_color", 320, 240, 3}};
  for (const auto& camera : cameras) {
    zmq::socket_t socket(context, zmq::socket_type::sub);
    socket.set(zmq::sockopt::subscribe, "");
    socket.set(zmq::sockopt::rcvtimeo, 20000);
    socket.connect("ipc://" + (run_directory_ / (std::string(camera.name) + ".frames")).string());
    int64_t last_seq = 0;
    for (int k = 0; k < 2; ++k) {
      zmq::message_t header, pixels;
      ASSERT_TRUE(socket.recv(header)) << camera.name;
      ASSERT_TRUE(header.more());
      ASSERT_TRUE(socket.recv(pixels));
      EXPECT_FALSE(pixels.more());
      const nlohmann::json frame = nlohmann::json::parse(header.to_string());
      EXPECT_EQ(frame["width"], camera.width);
      EXPECT_EQ(frame["height"], camera.height);
      EXPECT_EQ(frame["format"], camera.channels == 1 ? "gray8" : "bgr8");
      EXPECT_GT(frame["seq"].get<int64_t>(), last_seq);
      EXPECT_GT(frame["utime"].get<int64_t>(), 0);
      EXPECT_GT(frame["exposure_us"].get<int64_t>(), 0);
      EXPECT_EQ(pixels.size(), static_cast<size_t>(camera.width * camera.height * camera.channels));
      last_seq = frame["seq"];
    }
  }
}

TEST_F(SimulatorTest, ACameraTakesTheExposureAskedForOverItsSocket) {
  zmq::context_t context(1);
  zmq::socket_t socket(context, zmq::socket_type::xsub);
  socket.set(zmq::sockopt::rcvtimeo, 20000);
  socket.connect("ipc://" + (run_directory_ / "floor_color.frames").string());
  const auto say = [&socket](const std::string& bytes, bool more = false) {
    socket.send(zmq::buffer(bytes), more ? zmq::send_flags::sndmore : zmq::send_flags::none);
  };
  const auto next_exposure_us = [&socket] {
    zmq::message_t header, pixels;
    EXPECT_TRUE(socket.recv(header) && socket.recv(pixels));
    return nlohmann::json::parse(header.to_string())["exposure_us"].get<int64_t>();
  };
  say("\x01");
  const int64_t usual_us = next_exposure_us();
  for (const char* nonsense : {"", "exposure_us", "{\"exposure_us\":-1}", "{}", "\xff\xfe"}) {
    say(nonsense);
  }
  say("{\"exposure_us\":3000}", true);
  say("of several parts");
  for (int k = 0; k < 4; ++k) EXPECT_EQ(next_exposure_us(), usual_us);
  say("{\"exposure_us\":5000}");
  int frames = 1;
  while (next_exposure_us() == usual_us && frames < 20) ++frames;
  EXPECT_GT(frames, 1) << "no camera changes the frame it is taking";
  EXPECT_LT(frames, 20);
  EXPECT_EQ(next_exposure_us(), 5000);
}

TEST_F(SimulatorTest, LeavesNothingButTheTruthBehind) {
  for (const char* name : {"ptu.tty", "base.tty", "lasers.tty"}) {
    EXPECT_TRUE(std::filesystem::is_symlink(run_directory_ / name)) << name;
  }
  StopSimulator();
  for (const auto& entry : std::filesystem::directory_iterator(run_directory_)) {
    EXPECT_EQ(entry.path().filename(), "truth.jsonl");
  }
}

}  // namespace
}  // namespace geon::simulator
