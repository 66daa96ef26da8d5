#pragma once

#include <array>
#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "base/status.h"
#include "sim/simulated_robot.h"

namespace geon::simulator {

// Develops exposures and sends them to whoever has subscribed: one ZeroMQ socket a camera,
// ipc://<run>/head_color.frames, head_bw.frames and floor_color.frames. A message has two parts: a
// JSON header
// {"seq","utime","width","height","format","exposure_us"} and the pixels, rows tightly packed. A
// client may ask for an exposure over the same socket (camera_request.h); what is no request is
// dropped.
//
// Works in a thread of its own, so that the devices are served meanwhile. A camera without
// subscribers costs nothing. A frame that is exposed while the one before still waits is lost, and
// leaves a gap in seq.
class FramePublisher {
 public:
  static Result<std::unique_ptr<FramePublisher>> Open(const std::filesystem::path& run_directory,
                                                      sim::RigRenderer renderer,
                                                      int64_t epoch_utime);
  ~FramePublisher();

  // Never waits.
  void Offer(const sim::Exposure& exposure);
  // The exposure a client has asked for since last asked; the newest one.
  std::optional<double> TakeExposureRequest(sim::CameraId camera);

 private:
  struct Sockets;
  FramePublisher(std::unique_ptr<Sockets> sockets, sim::RigRenderer renderer, int64_t epoch_utime);
  void Run();
  void Send(const sim::Exposure& exposure);
  void Listen(size_t camera);

  std::unique_ptr<Sockets> sockets_;  // used by the thread only
  sim::RigRenderer renderer_;         // likewise
  int64_t epoch_utime_;               // when the world's time was 0
  std::array<std::atomic<bool>, sim::kCameras.size()> wanted_{};
  std::mutex mutex_;
  std::condition_variable offered_;
  std::array<std::optional<sim::Exposure>, sim::kCameras.size()> waiting_;
  std::array<std::optional<double>, sim::kCameras.size()> asked_exposure_s_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace geon::simulator
