#include "procs/simulator/simulator.h"

#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

namespace geon::simulator {
namespace {

constexpr std::array<const char*, sim::kDevices.size()> kLinkNames = {"ptu.tty", "base.tty",
                                                                      "lasers.tty"};
constexpr std::chrono::milliseconds kServiceInterval(2);

int64_t NowUtime() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

}  // namespace

Simulator::Simulator(std::unique_ptr<sim::SimulatedRobot> robot, int64_t epoch_utime)
    : robot_(std::move(robot)), epoch_utime_(epoch_utime) {}

Result<std::unique_ptr<Simulator>> Simulator::Open(const SimulatorSettings& settings) {
  std::error_code error;
  std::filesystem::create_directories(settings.run_directory, error);
  if (error) {
    return Status::Error(settings.run_directory.string() + ": cannot be made: " + error.message());
  }
  Result<std::unique_ptr<sim::SimulatedRobot>> robot =
      sim::SimulatedRobot::Create(settings.world, settings.rig, settings.options, settings.seed);
  if (!robot.ok()) return robot.status();
  auto simulator = std::unique_ptr<Simulator>(new Simulator(std::move(*robot), NowUtime()));
  Result<std::unique_ptr<TruthLog>> truth =
      TruthLog::Open(settings.truth_file, settings.world, settings.seed, simulator->epoch_utime_);
  if (!truth.ok()) return truth.status();
  simulator->truth_ = std::move(*truth);
  Result<std::unique_ptr<FramePublisher>> frames = FramePublisher::Open(
      settings.run_directory, simulator->robot_->MakeRenderer(), simulator->epoch_utime_);
  if (!frames.ok()) return frames.status();
  simulator->frames_ = std::move(*frames);
  for (const sim::DeviceId device : sim::kDevices) {
    const auto k = static_cast<size_t>(device);
    Result<PtyPort> port =
        PtyPort::Open(settings.run_directory / kLinkNames[k], simulator->robot_->baud(device));
    if (!port.ok()) return port.status();
    simulator->ports_[k].emplace(std::move(*port));
  }
  return simulator;
}

void Simulator::Serve(double time_s) {
  for (const sim::DeviceId device : sim::kDevices) {
    const PtyPort::Input input = ports_[static_cast<size_t>(device)]->Read();
    if (input.opened) robot_->PortOpened(device);
    robot_->Receive(device, input.bytes);
  }
  for (const sim::CameraId camera : sim::kCameras) {
    const std::optional<double> exposure_s = frames_->TakeExposureRequest(camera);
    if (exposure_s) robot_->SetExposure(camera, *exposure_s);
  }
  // Step by step, so that the truth misses nothing when this process was kept waiting.
  while (robot_->time_s() + sim::SimulatedRobot::kStep_s <= time_s) {
    robot_->Advance(robot_->time_s() + sim::SimulatedRobot::kStep_s);
    truth_->Observe(robot_->truth());
  }
  for (const sim::DeviceId device : sim::kDevices) {
    ports_[static_cast<size_t>(device)]->Write(robot_->Transmit(device));
  }
  for (const sim::Exposure& exposure : robot_->TakeExposures()) frames_->Offer(exposure);
}

void Simulator::Run(const std::atomic<bool>& stop) {
  // Time 0 of the world was when `epoch_utime_` was taken, while sockets were opened.
  const auto start =
      std::chrono::steady_clock::now() - std::chrono::microseconds(NowUtime() - epoch_utime_);
  auto next = std::chrono::steady_clock::now();
  while (!stop) {
    const auto now = std::chrono::steady_clock::now();
    Serve(std::chrono::duration<double>(now - start).count());
    next = std::max(next + kServiceInterval, now);
    std::this_thread::sleep_until(next);
  }
}

}  // namespace geon::simulator
