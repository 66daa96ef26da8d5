#include "procs/geon/recorded_scans.h"

#include <algorithm>

#include "messaging/channels.h"
#include "messaging/codec.h"
#include "procs/recognizer/scan_assembler.h"
#include "sensor/health.h"

namespace geon::cli {
namespace {

using recognizer::ScanAssembler;

// The same in every bit, but for the publisher's own count.
bool SameVerdict(sensor::GeonVerdict a, sensor::GeonVerdict b) {
  a.seq = 0;
  b.seq = 0;
  return messaging::Encode(a) == messaging::Encode(b);
}

class Replayer {
 public:
  Replayer(const recognizer::RecognizerConfig& config,
           const std::optional<recognizer::StripeCalibration>& calibration, ReplayedLog* log)
      : config_(config), calibration_(calibration), log_(log) {
    assembler_.emplace(config_.rig, calibration_, config_.assembler);
  }

  // Whether the message was good, or none of ours.
  bool Take(const messaging::LogEvent& event) {
    if (event.channel == messaging::kScanPlan) return Hand<sensor::ScanPlan>(event);
    if (event.channel == messaging::kTargetMask) return Hand<sensor::TargetMask>(event);
    if (event.channel == messaging::kStripe) return Hand<sensor::Stripe>(event);
    if (event.channel == messaging::kScanCommand) return Hand<sensor::ScanCommand>(event);
    if (event.channel == messaging::kGeonVerdict) return Hand<sensor::GeonVerdict>(event);
    if (event.channel == messaging::kGeonSession) return Hand<sensor::Session>(event);
    return true;
  }

 private:
  template <typename T>
  bool Hand(const messaging::LogEvent& event) {
    const Result<T> message = messaging::Decode<T>(event.bytes);
    if (!message.ok()) return false;
    Handle(*message);
    return true;
  }

  void Handle(const sensor::ScanPlan& plan) {
    assembler_->Take(plan);
    log_->scans[plan.scan_id].planned_stripes = assembler_->planned_stripes();
  }
  void Handle(const sensor::TargetMask& mask) { assembler_->Take(mask); }
  void Handle(const sensor::Stripe& stripe) {
    const ScanAssembler::Answer answer = assembler_->Take(stripe);
    if (answer.profile.status == sensor::ProfileStatus::kRefused) return;
    log_->scans[stripe.scan_id].good_stripes = assembler_->good_stripes();
    if (answer.verdict) log_->scans[stripe.scan_id].replayed = answer.verdict;
  }
  void Handle(const sensor::ScanCommand& command) {
    const auto verdict = assembler_->Take(command);
    if (verdict) log_->scans[command.scan_id].replayed = verdict;
  }
  void Handle(const sensor::GeonVerdict& verdict) {
    log_->scans[verdict.scan_id].recorded = verdict;
  }
  void Handle(const sensor::Session& session) {
    if (session.process != "geon-recognizer") return;
    if (start_utime_ && *start_utime_ != session.start_utime) {
      assembler_.emplace(config_.rig, calibration_, config_.assembler);
    }
    start_utime_ = session.start_utime;
    log_->recorded_calibration = session.calibration_hash;
  }

  const recognizer::RecognizerConfig& config_;
  const std::optional<recognizer::StripeCalibration>& calibration_;
  ReplayedLog* log_;
  std::optional<ScanAssembler> assembler_;
  std::optional<int64_t> start_utime_;  // of the recognizer that was heard last
};

}  // namespace

bool ReplayedLog::identical() const {
  return std::all_of(scans.begin(), scans.end(), [](const auto& entry) {
    return !entry.second.recorded || entry.second.identical;
  });
}

Result<ReplayedLog> ReplayLog(const std::filesystem::path& file,
                              const recognizer::RecognizerConfig& config,
                              const std::optional<recognizer::StripeCalibration>& calibration,
                              const std::function<void(double)>& progress) {
  Result<messaging::LogReader> reader = messaging::LogReader::Open(file);
  if (!reader.ok()) return reader.status();
  ReplayedLog log;
  Replayer replayer(config, calibration, &log);
  int64_t bytes_read = 0;
  while (const std::optional<messaging::LogEvent> event = reader->Next()) {
    ++log.events;
    if (!replayer.Take(*event)) ++log.unreadable;
    bytes_read += static_cast<int64_t>(event->bytes.size());
    progress(static_cast<double>(bytes_read) / static_cast<double>(reader->file_bytes()));
  }
  log.damage = reader->damage();
  for (auto& [id, scan] : log.scans) {
    scan.identical = scan.recorded && scan.replayed && SameVerdict(*scan.recorded, *scan.replayed);
  }
  return log;
}

}  // namespace geon::cli
