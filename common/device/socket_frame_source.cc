#include "device/socket_frame_source.h"

#include <zmq.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/contracts.h"
#include "base/time.h"
#include "device/frame_message.h"

namespace geon::device {
namespace {

// One part of a message, as ZeroMQ owns it.
class Part {
 public:
  Part() { zmq_msg_init(&message_); }
  ~Part() { zmq_msg_close(&message_); }
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  bool Receive(void* socket) { return zmq_msg_recv(&message_, socket, ZMQ_DONTWAIT) >= 0; }
  bool more() const { return zmq_msg_more(&message_) != 0; }
  std::span<const uint8_t> bytes() {
    return {static_cast<const uint8_t*>(zmq_msg_data(&message_)), zmq_msg_size(&message_)};
  }
  std::string_view text() {
    return {static_cast<const char*>(zmq_msg_data(&message_)), zmq_msg_size(&message_)};
  }

 private:
  zmq_msg_t message_;
};

}  // namespace

struct SocketFrameSource::Socket {
  explicit Socket(const std::string& endpoint) : context(zmq_ctx_new()) {
    socket = zmq_socket(context, ZMQ_XSUB);  // subscribes, and can speak to the publisher
    const int few_frames = 4;                // a busy daemon wants the newest, not a queue
    const int no_linger = 0;
    zmq_setsockopt(socket, ZMQ_RCVHWM, &few_frames, sizeof(few_frames));
    zmq_setsockopt(socket, ZMQ_LINGER, &no_linger, sizeof(no_linger));
    Require(zmq_connect(socket, endpoint.c_str()) == 0,
            "no ZeroMQ endpoint: " + endpoint + ": " + zmq_strerror(zmq_errno()));
    const char subscribe_to_all = 1;
    zmq_send(socket, &subscribe_to_all, 1, ZMQ_DONTWAIT);
  }
  ~Socket() {
    zmq_close(socket);
    zmq_ctx_term(context);
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  void* context;
  void* socket = nullptr;
};

SocketFrameSource::SocketFrameSource(const std::string& endpoint, const FrameSourceOptions& options)
    : options_(options), endpoint_(endpoint), socket_(std::make_unique<Socket>(endpoint)) {}

SocketFrameSource::~SocketFrameSource() = default;

int SocketFrameSource::file_descriptor() const {
  int fd = -1;
  size_t size = sizeof(fd);
  zmq_getsockopt(socket_->socket, ZMQ_FD, &fd, &size);
  return fd;
}

Result<std::optional<sensor::Image>> SocketFrameSource::Poll(double time_s) {
  if (!last_frame_s_) last_frame_s_ = time_s;  // the wait for the first frame begins
  SendRequest();
  std::optional<sensor::Image> newest;
  Status trouble;
  // The descriptor tells edges, not levels: everything must be taken out each time.
  while (true) {
    Result<std::optional<sensor::Image>> frame = ReceiveOne();
    if (!frame.ok()) {
      trouble = frame.status();
      continue;
    }
    if (!frame->has_value()) break;
    if (!watch_.IsFreshStamp((*frame)->utime)) {
      trouble = Status::Error("frames repeat the stamp " + std::to_string((*frame)->utime));
      continue;
    }
    newest = std::move(*frame);
  }
  if (newest) {
    last_frame_s_ = time_s;
    reconnects_ += std::exchange(timed_out_, false) ? 1 : 0;
    return newest;
  }
  if (time_s - *last_frame_s_ < options_.timeout_s) {
    return trouble.ok() ? Result<std::optional<sensor::Image>>(std::nullopt)
                        : Result<std::optional<sensor::Image>>(trouble.In(endpoint_));
  }
  if (!timed_out_) watch_.Reset();  // who publishes next may have another clock
  timed_out_ = true;
  return Status::Error(endpoint_ + ": no fresh frame for " +
                       std::to_string(std::lround(1e3 * options_.timeout_s)) + " ms" +
                       (trouble.ok() ? "" : " (" + trouble.message() + ")"));
}

Status SocketFrameSource::SetExposure(double exposure_s) {
  Require(exposure_s > 0.0, "SetExposure: exposure_s must be positive");
  asked_exposure_s_ = exposure_s;
  return Status::Ok();
}

// Before frames are taken out, since sending may swallow the descriptor's edge. A request that
// finds no publisher is lost; the frames of the one that comes say so.
void SocketFrameSource::SendRequest() {
  if (!asked_exposure_s_) return;
  const std::string request =
      nlohmann::json{{"exposure_us", MicrosecondsFromSeconds(*asked_exposure_s_)}}.dump();
  zmq_send(socket_->socket, request.data(), request.size(), ZMQ_DONTWAIT);
  asked_exposure_s_.reset();
}

Result<std::optional<sensor::Image>> SocketFrameSource::ReceiveOne() {
  Part header;
  if (!header.Receive(socket_->socket)) return std::optional<sensor::Image>();
  if (!header.more()) return Status::Error("a frame message of one part");
  Part pixels;
  if (!pixels.Receive(socket_->socket)) return Status::Error("a frame message without pixels");
  bool extra = pixels.more();
  const bool has_extra = extra;
  while (extra) {
    Part part;
    extra = part.Receive(socket_->socket) && part.more();
  }
  if (has_extra) return Status::Error("a frame message of more than two parts");
  Result<sensor::Image> image = ParseFrame(header.text(), pixels.bytes());
  if (!image.ok()) return image.status();
  if (Status status = CheckFrame(*image); !status.ok()) return status;
  return std::optional<sensor::Image>(std::move(*image));
}

Status SocketFrameSource::CheckFrame(const sensor::Image& image) const {
  if (image.width_px != options_.width_px || image.height_px != options_.height_px) {
    return Status::Error(
        "a frame of " + std::to_string(image.width_px) + "x" + std::to_string(image.height_px) +
        ", not " + std::to_string(options_.width_px) + "x" + std::to_string(options_.height_px));
  }
  if (image.format != options_.format) return Status::Error("a frame of the wrong pixel format");
  return Status::Ok();
}

}  // namespace geon::device
