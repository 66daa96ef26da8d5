#include "procs/geon/run_record.h"

#include <algorithm>
#include <cmath>

#include "base/time.h"
#include "messaging/channels.h"
#include "messaging/codec.h"

namespace geon::cli {
namespace {

constexpr double kPathStep_m = 0.02;
constexpr double kPathTurn_rad = 0.1;
constexpr double kPolygonStep_m = 0.4;  // of the robot between two safe polygons that are kept

class Recorder {
 public:
  explicit Recorder(RunRecord* run) : run_(run) {}

  void Take(const messaging::LogEvent& event) {
    if (run_->events++ == 0) run_->first_utime = event.utime;
    time_s_ = std::max(time_s_, SecondsFromMicroseconds(event.utime - run_->first_utime));
    const auto bytes = static_cast<int64_t>(event.bytes.size());
    run_->bytes += bytes;
    run_->duration_s = time_s_;
    if (const auto head = messaging::ReadMessageHead(event.bytes)) {
      run_->channels.CountReceived(event.channel, head->seq, bytes);
    }
    if (!Dispatch(event)) run_->channels.CountRefused(event.channel);
  }

  // Closes what is still open at the end of the log.
  void Finish() {
    if (run_->phases.empty()) return;
    run_->phases.back().end_s = time_s_;
  }

 private:
  bool Dispatch(const messaging::LogEvent& event) {
    const std::string& channel = event.channel;
    if (channel == messaging::kGeonVerdict) return Hand<sensor::GeonVerdict>(event);
    if (channel == messaging::kScanPlan) return Hand<sensor::ScanPlan>(event);
    if (channel == messaging::kRangeProfile) return Hand<sensor::RangeProfile>(event);
    if (channel == messaging::kTargetView) return Hand<sensor::TargetView>(event);
    if (channel == messaging::kPlannerState) return Hand<sensor::PlannerState>(event);
    if (channel == messaging::kBaseState) return Hand<sensor::BaseState>(event);
    if (channel == messaging::kBumper) return Hand<sensor::BumperState>(event);
    if (channel == messaging::kGeonSession) return Hand<sensor::Session>(event);
    if (channel.starts_with(messaging::kHealthPrefix)) return Hand<sensor::Health>(event);
    return true;
  }

  template <typename T>
  bool Hand(const messaging::LogEvent& event) {
    const Result<T> message = messaging::Decode<T>(event.bytes);
    if (message.ok()) Handle(*message);
    return message.ok();
  }

  void Handle(const sensor::GeonVerdict& verdict) { run_->verdict = verdict; }
  void Handle(const sensor::ScanPlan& plan) {
    if (!run_->plan || run_->plan->scan_id != plan.scan_id) {
      run_->profiles.clear();
      run_->stripes_answered = 0;
    }
    run_->plan = plan;
  }
  void Handle(const sensor::RangeProfile& profile) {
    if (!run_->plan || profile.scan_id != run_->plan->scan_id) return;
    ++run_->stripes_answered;
    const auto index = static_cast<size_t>(profile.stripe_index);
    if (profile.status != sensor::ProfileStatus::kOk || profile.stripe_index < 0 ||
        index >= run_->plan->stripes.size()) {
      return;
    }
    // As the recognizer does: of a sweep's stripes the one nearest to its place, of others the
    // last.
    const auto known = run_->profiles.emplace(profile.stripe_index, profile).first;
    if (Misplacement(*run_->plan, profile) <= Misplacement(*run_->plan, known->second)) {
      known->second = profile;
    }
  }
  void Handle(const sensor::TargetView& view) {
    if (!view.view.data.empty()) run_->views.push_back(view);
  }
  void Handle(const sensor::PlannerState& state) {
    auto& phases = run_->phases;
    if (phases.empty() || phases.back().phase != state.phase) {
      if (!phases.empty()) phases.back().end_s = time_s_;
      phases.push_back({state.phase, state.text, time_s_, time_s_});
    }
    phases.back().text = state.text;
    run_->last_state = state;
    KeepPolygon(state);
  }
  void Handle(const sensor::BaseState& state) {
    if (state.status != sensor::DeviceStatus::kReady) return;
    auto& path = run_->path;
    const bool moved =
        path.empty() ||
        std::hypot(state.x_m - path.back().x_m, state.y_m - path.back().y_m) > kPathStep_m ||
        std::abs(state.heading_rad - path.back().heading_rad) > kPathTurn_rad;
    if (moved) path.push_back(state);
  }
  void Handle(const sensor::BumperState& state) {
    run_->contacts = std::max(run_->contacts, state.contact_count);
  }
  void Handle(const sensor::Session& session) { run_->sessions[session.process] = session; }
  void Handle(const sensor::Health& health) {
    ProcessHealth& process = run_->health[health.process];
    if (process.starts == 0 || process.last.pid != health.pid) ++process.starts;
    process.last = health;
    if (health.level > process.worst) {
      process.worst = health.level;
      process.worst_text = health.text;
    }
  }

  void KeepPolygon(const sensor::PlannerState& state) {
    if (state.safe_polygon_W_m.size() < 3) return;
    auto& kept = run_->safe_states;
    if (!kept.empty() &&
        std::hypot(state.x_m - kept.back().x_m, state.y_m - kept.back().y_m) < kPolygonStep_m) {
      return;
    }
    kept.push_back(state);
  }

  RunRecord* run_;
  double time_s_ = 0.0;
};

}  // namespace

Result<RunRecord> ReadRun(const std::filesystem::path& log) {
  Result<messaging::LogReader> reader = messaging::LogReader::Open(log);
  if (!reader.ok()) return reader.status();
  RunRecord run;
  run.file = log.string();
  Recorder recorder(&run);
  while (const std::optional<messaging::LogEvent> event = reader->Next()) recorder.Take(*event);
  recorder.Finish();
  run.damage = reader->damage();
  return run;
}

}  // namespace geon::cli
