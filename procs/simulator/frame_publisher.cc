#include "procs/simulator/frame_publisher.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <utility>
#include <vector>
#include <zmq.hpp>

#include "base/time.h"
#include "procs/simulator/camera_request.h"

namespace geon::simulator {
namespace {

constexpr std::array<const char*, sim::kCameras.size()> kSocketNames = {
    "head_color.frames", "head_bw.frames", "floor_color.frames"};

// How often new subscribers are looked for.
constexpr std::chrono::milliseconds kSubscriberInterval(20);

}  // namespace

struct FramePublisher::Sockets {
  Sockets() = default;
  Sockets(const Sockets&) = delete;
  Sockets& operator=(const Sockets&) = delete;
  ~Sockets() {
    publishers.clear();
    std::error_code ignored;  // ZeroMQ leaves the files behind
    for (const std::filesystem::path& file : files) std::filesystem::remove(file, ignored);
  }

  zmq::context_t context{1};
  std::vector<std::filesystem::path> files;
  std::vector<zmq::socket_t> publishers;
  std::array<int, sim::kCameras.size()> subscribers{};
};

Result<std::unique_ptr<FramePublisher>> FramePublisher::Open(
    const std::filesystem::path& run_directory, sim::RigRenderer renderer, int64_t epoch_utime) {
  auto sockets = std::make_unique<Sockets>();
  for (const char* name : kSocketNames) {
    const std::filesystem::path file = std::filesystem::absolute(run_directory) / name;
    const std::string address = "ipc://" + file.string();
    try {
      zmq::socket_t socket(sockets->context, zmq::socket_type::xpub);
      socket.set(zmq::sockopt::linger, 0);
      socket.set(zmq::sockopt::sndhwm,
                 2);  // a slow reader loses frames instead of reading old ones
      // Every joining and leaving is told, not only the first and the last.
      socket.set(zmq::sockopt::xpub_verboser, 1);
      socket.set(zmq::sockopt::maxmsgsize, int64_t{1024});  // of what clients send
      socket.bind(address);
      sockets->publishers.push_back(std::move(socket));
      sockets->files.push_back(file);
    } catch (const zmq::error_t& error) {
      return Status::Error(address + ": " + error.what() +
                           " (is the run directory's path too long, or not writable?)");
    }
  }
  return std::unique_ptr<FramePublisher>(
      new FramePublisher(std::move(sockets), std::move(renderer), epoch_utime));
}

FramePublisher::FramePublisher(std::unique_ptr<Sockets> sockets, sim::RigRenderer renderer,
                               int64_t epoch_utime)
    : sockets_(std::move(sockets)),
      renderer_(std::move(renderer)),
      epoch_utime_(epoch_utime),
      thread_([this] { Run(); }) {}

FramePublisher::~FramePublisher() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  offered_.notify_one();
  thread_.join();
}

void FramePublisher::Offer(const sim::Exposure& exposure) {
  const auto camera = static_cast<size_t>(exposure.camera);
  if (!wanted_[camera]) return;
  {
    const std::lock_guard lock(mutex_);
    if (waiting_[camera]) return;
    waiting_[camera] = exposure;
  }
  offered_.notify_one();
}

void FramePublisher::Run() {
  size_t turn = 0;
  while (true) {
    std::optional<sim::Exposure> next;
    {
      std::unique_lock lock(mutex_);
      const auto ready = [this] {
        for (const auto& exposure : waiting_) {
          if (exposure) return true;
        }
        return stop_;
      };
      offered_.wait_for(lock, kSubscriberInterval, ready);
      if (stop_) return;
      // Cameras take turns, so that a slow machine starves none.
      for (size_t k = 0; k < waiting_.size() && !next; ++k) {
        next = std::exchange(waiting_[(turn + k) % waiting_.size()], std::nullopt);
      }
    }
    if (next) {
      turn = static_cast<size_t>(next->camera) + 1;
      Send(*next);
    }
    for (size_t camera = 0; camera < wanted_.size(); ++camera) Listen(camera);
  }
}

// Reads what comes from the subscribers: that they join (1) or leave (0), and requests.
void FramePublisher::Listen(size_t camera) {
  int& subscribers = sockets_->subscribers[camera];
  zmq::message_t message;
  bool is_rest = false;  // of a message of several parts: no request
  while (sockets_->publishers[camera].recv(message, zmq::recv_flags::dontwait)) {
    const bool in_parts = std::exchange(is_rest, message.more()) || message.more();
    if (message.empty()) continue;
    const auto* bytes = message.data<uint8_t>();
    if (bytes[0] <= 1) {
      subscribers = std::max(0, subscribers + (bytes[0] == 1 ? 1 : -1));
    } else if (const auto exposure_s = ParseExposureRequest({bytes, message.size()});
               exposure_s.ok() && !in_parts) {
      const std::lock_guard lock(mutex_);
      asked_exposure_s_[camera] = *exposure_s;
    }
  }
  wanted_[camera] = subscribers > 0;
}

std::optional<double> FramePublisher::TakeExposureRequest(sim::CameraId camera) {
  const std::lock_guard lock(mutex_);
  return std::exchange(asked_exposure_s_[static_cast<size_t>(camera)], std::nullopt);
}

void FramePublisher::Send(const sim::Exposure& exposure) {
  const sim::Frame frame = sim::Develop(exposure, &renderer_);
  const nlohmann::json header = {
      {"seq", exposure.seq},
      {"utime", epoch_utime_ + MicrosecondsFromSeconds(exposure.start_s)},
      {"width", frame.width_px},
      {"height", frame.height_px},
      {"format", frame.channels == 1 ? "gray8" : "bgr8"},
      {"exposure_us", MicrosecondsFromSeconds(exposure.exposure_s)}};
  zmq::socket_t& socket = sockets_->publishers[static_cast<size_t>(exposure.camera)];
  socket.send(zmq::buffer(header.dump()), zmq::send_flags::sndmore | zmq::send_flags::dontwait);
  socket.send(zmq::buffer(frame.pixels), zmq::send_flags::dontwait);
}

}  // namespace geon::simulator
