#include "messaging/health_reporter.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <utility>

#include "messaging/channels.h"
#include "messaging/clock.h"
#include "messaging/message_schema.h"

namespace geon::messaging {
namespace {

std::string HostName() {
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0) return "unknown";
  return name.data();
}

double ProcessorTime() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) * 1e-6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

int64_t ResidentBytes() {
  std::ifstream statm("/proc/self/statm");
  int64_t total_pages = 0;
  int64_t resident_pages = 0;
  statm >> total_pages >> resident_pages;
  return resident_pages * sysconf(_SC_PAGESIZE);
}

}  // namespace

std::string HealthChannel(std::string_view process) {
  constexpr std::string_view kOurs = "geon-";
  if (process.rfind(kOurs, 0) == 0) process.remove_prefix(kOurs.size());
  std::string channel(kHealthPrefix);
  for (const char c : process) {
    channel += c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return channel;
}

HealthReporter::HealthReporter(Bus* bus, PollLoop* loop, HealthIdentity identity)
    : bus_(bus),
      loop_(loop),
      channel_(HealthChannel(identity.process)),
      start_s_(MonotonicSeconds()),
      last_s_(start_s_) {
  health_.host = session_.host = HostName();
  health_.pid = getpid();
  health_.process = session_.process = std::move(identity.process);
  health_.version = session_.version = std::move(identity.version);
  health_.config_hash = session_.config_hash = std::move(identity.config_hash);
  session_.start_utime = Utime();
  session_.types_hash = TypesHash();
  loop_->Every(1.0, [this] { PublishHealth(); });
  loop_->Every(5.0, [this] { PublishSession(); });
}

void HealthReporter::SetLevel(sensor::HealthLevel level, const std::string& text) {
  health_.level = level;
  health_.text = text;
}

void HealthReporter::ReportAge(double age_s) {
  health_.max_age_s = std::max(health_.max_age_s, age_s);
}

void HealthReporter::SetCalibration(const std::string& hash, const std::string& file) {
  session_.calibration_hash = hash;
  session_.calibration_file = file;
}

void HealthReporter::PublishHealth() {
  const double now_s = MonotonicSeconds();
  if (now_s > last_s_) {
    health_.loop_hz = static_cast<double>(loop_->rounds() - last_rounds_) / (now_s - last_s_);
  }
  last_s_ = now_s;
  last_rounds_ = loop_->rounds();
  health_.utime = Utime();
  health_.seq += 1;
  health_.uptime_s = now_s - start_s_;
  health_.rx_lost = bus_->statistics().lost();
  health_.decode_errors = bus_->statistics().refused();
  health_.cpu_s = ProcessorTime();
  health_.rss_bytes = ResidentBytes();
  bus_->Publish(channel_, health_);
  health_.max_age_s = 0.0;
}

void HealthReporter::PublishSession() {
  session_.utime = Utime();
  session_.seq += 1;
  bus_->Publish(kGeonSession, session_);
}

}  // namespace geon::messaging
