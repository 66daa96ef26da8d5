#pragma once

#include <lcm/lcm.h>

#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "messaging/bus_statistics.h"
#include "messaging/codec.h"
#include "messaging/rate_limiter.h"

namespace geon::messaging {

struct BusOptions {
  std::string url;      // empty: LCM_DEFAULT_URL, else LCM's own default
  std::string process;  // who we are, for messages to people
  // How long Open() waits for a route to the multicast group (a network that is still coming up).
  double route_timeout_s = 10.0;
  // Where warnings go; empty: the log.
  std::function<void(const std::string&)> warn = nullptr;
};

// One process's place on the LCM bus. Single-threaded: watch file_descriptor() in a PollLoop and
// call HandlePending() when it is readable; handlers run in there, in order of arrival. What a
// handler throws leaves through HandlePending(), never through LCM's C code. Bytes that are not a
// good message are counted, named in a rate-limited warning and dropped.
//
// Structs go out as they are: the publisher sets utime (acquisition) and seq (one more per message
// of the channel, from 1). Loss is counted by the receiver.
class Bus {
 public:
  static Result<std::unique_ptr<Bus>> Open(const BusOptions& options);
  ~Bus();
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  template <typename T>
  void Publish(std::string_view channel, const T& value) {
    PublishBytes(channel, Encode(value));
  }

  // Every message. `channel` may be a pattern (kAnyHealth). Throws std::runtime_error when LCM
  // cannot receive (its message says why): let it end the process, the supervisor will try again.
  template <typename T>
  void Subscribe(std::string_view channel, std::function<void(const T&)> handler) {
    SubscribeBytes(channel, kEvery, WireFingerprint<T>(), Decoding(std::move(handler)));
  }

  // The newest message only: HandlePending() drains what has queued up and hands over the last one.
  // For images, and for states of which only the present counts.
  template <typename T>
  void SubscribeLatest(std::string_view channel, std::function<void(const T&)> handler) {
    SubscribeBytes(channel, kLatest, WireFingerprint<T>(), Decoding(std::move(handler)));
  }

  int file_descriptor() const;
  void HandlePending();
  const BusStatistics& statistics() const { return statistics_; }
  // As opened, receive buffer included.
  const std::string& url() const { return url_; }

 private:
  enum Delivery { kEvery, kLatest };
  using BytesHandler = std::function<Status(std::span<const uint8_t>)>;
  struct Subscription {
    Bus* bus = nullptr;
    Delivery delivery = kEvery;
    uint64_t fingerprint = 0;
    BytesHandler handler;
    std::map<std::string, std::vector<uint8_t>, std::less<>> newest;  // kLatest: by channel
  };

  Bus(lcm_t* lcm, std::string url, const BusOptions& options);
  template <typename T>
  static BytesHandler Decoding(std::function<void(const T&)> handler) {
    return [handler = std::move(handler)](std::span<const uint8_t> bytes) -> Status {
      Result<T> value = Decode<T>(bytes);
      if (!value.ok()) return value.status();
      handler(*value);
      return Status::Ok();
    };
  }
  void PublishBytes(std::string_view channel, const std::vector<uint8_t>& bytes);
  void SubscribeBytes(std::string_view channel, Delivery delivery, uint64_t fingerprint,
                      BytesHandler handler);
  static void OnMessage(const lcm_recv_buf_t* buffer, const char* channel, void* subscription);
  void Receive(Subscription* subscription, std::string_view channel, const lcm_recv_buf_t& buffer);
  void Deliver(Subscription* subscription, std::string_view channel,
               std::span<const uint8_t> bytes);
  void Refuse(std::string_view channel, const std::string& why);
  void WarnOfLoss(std::string_view channel, int64_t lost, size_t size);
  void Warn(const std::string& text);

  lcm_t* lcm_;
  std::string url_;
  std::string process_;
  std::function<void(const std::string&)> warn_;
  std::vector<std::unique_ptr<Subscription>> subscriptions_;
  BusStatistics statistics_;
  std::map<std::string, RateLimiter, std::less<>> refusals_;
  RateLimiter losses_;
  RateLimiter failed_publishes_;
  std::exception_ptr thrown_;
};

}  // namespace geon::messaging
