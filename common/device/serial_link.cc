#include "device/serial_link.h"

#include <utility>

#include "base/contracts.h"

namespace geon::device {
namespace {

// More than this unsent means that nobody takes the bytes: a command is at most 300.
constexpr size_t kMostUnsent = 2048;

}  // namespace

SerialLink::SerialLink(const SerialLinkOptions& options)
    : options_(options), retry_(options.first_retry_s, options.longest_retry_s) {
  Require(!options.path.empty(), "SerialLink: the path must not be empty");
  Require(options.first_retry_s > 0.0 && options.longest_retry_s >= options.first_retry_s,
          "SerialLink: retries must wait, and not shrink");
}

SerialLink::Traffic SerialLink::Service(double time_s) {
  Traffic traffic;
  if (!port_ && !lost_ && retry_.Due(time_s)) {
    Result<SerialPort> opened = SerialPort::Open(options_.path, options_.baud);
    if (opened.ok()) {
      port_ = std::move(opened).value();
      trouble_.clear();
      unsent_.clear();
      if (ever_open_) ++reconnects_;
      ever_open_ = true;
      traffic.opened = true;
    } else {
      trouble_ = opened.message();
      retry_.Failed(time_s);
    }
  }
  if (port_ && !unsent_.empty()) Send({});
  if (port_) {
    Result<std::string> received = port_->Read();
    if (received.ok()) {
      traffic.bytes = std::move(received).value();
      // Only bytes prove a device: a path that opens and hangs up at once keeps its back-off.
      if (!traffic.bytes.empty()) retry_.Succeeded();
    } else {
      Lose(received.status());
    }
  }
  if (lost_) {
    lost_ = false;
    traffic.lost = true;
    retry_.Failed(time_s);
  }
  return traffic;
}

void SerialLink::Send(std::string_view bytes) {
  if (!port_) return;
  unsent_ += bytes;
  const Result<size_t> written = port_->Write(unsent_);
  if (!written.ok()) {
    Lose(written.status());
    return;
  }
  unsent_.erase(0, *written);
  if (unsent_.size() > kMostUnsent) {
    Lose(Status::Error(options_.path + ": takes no bytes; check the device"));
  }
}

void SerialLink::WaitReadable(double timeout_s) const {
  if (port_) port_->WaitReadable(timeout_s);
}

void SerialLink::Lose(const Status& status) {
  trouble_ = status.message();
  port_.reset();
  unsent_.clear();
  lost_ = true;
}

}  // namespace geon::device
