#include "messaging/bus.h"

#include <poll.h>
#include <spdlog/spdlog.h>

#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "messaging/bus_url.h"
#include "messaging/clock.h"

namespace geon::messaging {
namespace {

// LCM drops the newest message when a subscription's queue is full. Long enough for a few seconds
// of a busy handler at camera rate; bounded, so that a stuck process does not eat the memory.
constexpr int kQueueCapacity = 100;
// Messages handled before the loop gets a turn for timers and signals.
constexpr int kLongestBatch = 200;

std::string DefaultUrl() {
  const char* url = std::getenv("LCM_DEFAULT_URL");
  return url != nullptr && *url != '\0' ? url : "udpm://239.255.76.67:7667?ttl=0";
}

// LCM answers a missing multicast route with a null pointer: wait for a network that is coming up.
lcm_t* CreateWaiting(const std::string& url, double timeout_s) {
  const double deadline_s = MonotonicSeconds() + timeout_s;
  lcm_t* lcm = lcm_create(url.c_str());
  while (lcm == nullptr && MonotonicSeconds() < deadline_s) {
    poll(nullptr, 0, 1000);
    lcm = lcm_create(url.c_str());
  }
  return lcm;
}

}  // namespace

Result<std::unique_ptr<Bus>> Bus::Open(const BusOptions& options) {
  const std::string url = WithReceiveBuffer(options.url.empty() ? DefaultUrl() : options.url);
  lcm_t* lcm = CreateWaiting(url, options.route_timeout_s);
  if (lcm == nullptr) {
    return Status::Error(
        "LCM does not open " + url +
        ": is the URL right, and is there a route for multicast? On one machine: "
        "`sudo ip link set lo multicast on; sudo ip route add 224.0.0.0/4 dev lo`");
  }
  auto bus = std::unique_ptr<Bus>(new Bus(lcm, url, options));
  if (const auto limits = ReadKernelBufferLimits()) {
    if (const auto warning = ReceiveBufferWarning(url, *limits)) bus->Warn(*warning);
  }
  return bus;
}

Bus::Bus(lcm_t* lcm, std::string url, const BusOptions& options)
    : lcm_(lcm), url_(std::move(url)), process_(options.process), warn_(options.warn) {}

Bus::~Bus() { lcm_destroy(lcm_); }

int Bus::file_descriptor() const { return lcm_get_fileno(lcm_); }

void Bus::PublishBytes(std::string_view channel, const std::vector<uint8_t>& bytes) {
  const std::string name(channel);
  if (lcm_publish(lcm_, name.c_str(), bytes.data(), static_cast<unsigned>(bytes.size())) == 0) {
    return;
  }
  if (const auto times = failed_publishes_.Pass(MonotonicSeconds())) {
    Warn("publishing on " + name + " failed (" + std::to_string(*times) + " times)");
  }
}

void Bus::SubscribeBytes(std::string_view channel, Delivery delivery, uint64_t fingerprint,
                         BytesHandler handler) {
  auto subscription = std::make_unique<Subscription>();
  subscription->bus = this;
  subscription->delivery = delivery;
  subscription->fingerprint = fingerprint;
  subscription->handler = std::move(handler);
  const std::string pattern(channel);
  lcm_subscription_t* handle =
      lcm_subscribe(lcm_, pattern.c_str(), &Bus::OnMessage, subscription.get());
  if (handle == nullptr) {
    throw std::runtime_error("LCM cannot receive " + pattern + " on " + url_ +
                             ": its multicast self-test failed (firewall? route for 224.0.0.0/4?)");
  }
  lcm_subscription_set_queue_capacity(handle, kQueueCapacity);
  subscriptions_.push_back(std::move(subscription));
}

void Bus::HandlePending() {
  for (int i = 0; i < kLongestBatch && !thrown_; ++i) {
    if (lcm_handle_timeout(lcm_, 0) <= 0) break;
  }
  for (const auto& subscription : subscriptions_) {
    if (thrown_) break;
    auto newest = std::exchange(subscription->newest, {});
    for (const auto& [channel, bytes] : newest) Deliver(subscription.get(), channel, bytes);
  }
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

void Bus::OnMessage(const lcm_recv_buf_t* buffer, const char* channel, void* context) {
  auto* subscription = static_cast<Subscription*>(context);
  try {
    subscription->bus->Receive(subscription, channel, *buffer);
  } catch (...) {
    subscription->bus->thrown_ = std::current_exception();
  }
}

void Bus::Receive(Subscription* subscription, std::string_view channel,
                  const lcm_recv_buf_t& buffer) {
  // A crafted datagram makes LCM 1.3.1 report sizes near 4 GB, with no such bytes behind them.
  constexpr uint32_t kLargestMessage = 64u << 20;
  if (buffer.data_size > kLargestMessage) {
    Refuse(channel, "claims " + std::to_string(buffer.data_size) + " bytes");
    return;
  }
  const std::span<const uint8_t> bytes(static_cast<const uint8_t*>(buffer.data), buffer.data_size);
  const std::optional<MessageHead> head = ReadMessageHead(bytes);
  if (!head) {
    Refuse(channel, "only " + std::to_string(bytes.size()) + " bytes");
    return;
  }
  if (const Status status = CheckFingerprint(head->fingerprint, subscription->fingerprint);
      !status.ok()) {
    Refuse(channel, status.message());
    return;
  }
  const auto size = static_cast<int64_t>(bytes.size());
  WarnOfLoss(channel, statistics_.CountReceived(channel, head->seq, size), bytes.size());
  if (subscription->delivery == kLatest) {
    subscription->newest[std::string(channel)].assign(bytes.begin(), bytes.end());
  } else {
    Deliver(subscription, channel, bytes);
  }
}

void Bus::Deliver(Subscription* subscription, std::string_view channel,
                  std::span<const uint8_t> bytes) {
  try {
    if (const Status status = subscription->handler(bytes); !status.ok()) {
      Refuse(channel, status.message());
    }
  } catch (...) {
    thrown_ = std::current_exception();
  }
}

void Bus::Refuse(std::string_view channel, const std::string& why) {
  statistics_.CountRefused(channel);
  const auto times = refusals_[std::string(channel)].Pass(MonotonicSeconds());
  if (!times) return;
  Warn("refused " + std::to_string(*times) + " message(s) on " + std::string(channel) + ": " + why);
}

void Bus::WarnOfLoss(std::string_view channel, int64_t lost, size_t size) {
  if (lost == 0) return;
  const auto times = losses_.Pass(MonotonicSeconds());
  if (!times) return;
  std::string text = "messages lost on " + std::string(channel) + " (" + std::to_string(size) +
                     " bytes each), " + std::to_string(statistics_.lost()) + " in all since start";
  const auto limits = ReadKernelBufferLimits();
  const auto cause = limits ? ReceiveBufferWarning(url_, *limits) : std::nullopt;
  if (cause) text += "; " + *cause;
  Warn(text);
}

void Bus::Warn(const std::string& text) {
  if (warn_) {
    warn_(text);
  } else {
    spdlog::warn("{}", text);
  }
}

}  // namespace geon::messaging
