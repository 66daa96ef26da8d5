#pragma once

#include <memory>
#include <optional>
#include <string>

#include "device/frame_source.h"
#include "device/frame_watch.h"

namespace geon::device {

// `sim:ENDPOINT`: frames published on a ZeroMQ socket (device/frame_message.h), as the simulator
// does. ZeroMQ reconnects by itself; frames that are not what their header says are errors and are
// dropped. What is asked of the camera goes the other way, as a message of one part:
//   {"exposure_us":int}
class SocketFrameSource : public FrameSource {
 public:
  SocketFrameSource(const std::string& endpoint, const FrameSourceOptions& options);
  ~SocketFrameSource() override;

  int file_descriptor() const override;
  Result<std::optional<sensor::Image>> Poll(double time_s) override;
  int reconnects() const override { return reconnects_; }
  Status SetExposure(double exposure_s) override;

 private:
  struct Socket;
  void SendRequest();
  Result<std::optional<sensor::Image>> ReceiveOne();
  Status CheckFrame(const sensor::Image& image) const;

  FrameSourceOptions options_;
  std::string endpoint_;
  std::unique_ptr<Socket> socket_;
  std::optional<double> asked_exposure_s_;  // not yet sent
  FrameWatch watch_;
  std::optional<double> last_frame_s_;
  bool timed_out_ = false;
  int reconnects_ = 0;
};

}  // namespace geon::device
