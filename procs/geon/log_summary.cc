#include "procs/geon/log_summary.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/time.h"
#include "messaging/channels.h"
#include "messaging/codec.h"
#include "messaging/message_schema.h"
#include "sensor/health.h"

namespace geon::cli {
namespace {

using messaging::LogEvent;

std::string Hex(uint64_t fingerprint) {
  char text[24];
  std::snprintf(text, sizeof(text), "?? %016llx", static_cast<unsigned long long>(fingerprint));
  return text;
}

void AddSession(const LogEvent& event, LogSummary* summary) {
  const Result<sensor::Session> session = messaging::Decode<sensor::Session>(event.bytes);
  if (!session.ok()) return;
  summary->versions.insert(session->version);
  if (session->types_hash != messaging::TypesHash()) ++summary->foreign_sessions;
}

// What the LCM library sends itself when a process subscribes for the first time.
constexpr std::string_view kLcmSelfTest = "LCM_SELF_TEST";

void AddEvent(const LogEvent& event, messaging::BusStatistics* statistics, LogSummary* summary) {
  if (event.channel == kLcmSelfTest) return;
  if (summary->events++ == 0) summary->first_utime = event.utime;
  summary->last_utime = std::max(summary->last_utime, event.utime);
  LogChannel& channel = summary->channels[event.channel];
  if (channel.events++ == 0) {
    channel.first_utime = event.utime;
  } else {
    channel.longest_gap_us = std::max(channel.longest_gap_us, event.utime - channel.last_utime);
  }
  channel.last_utime = event.utime;
  const auto size = static_cast<int64_t>(event.bytes.size());
  channel.bytes += size;

  const std::optional<messaging::MessageHead> head = messaging::ReadMessageHead(event.bytes);
  const std::string_view type =
      head ? messaging::TypeNameOf(head->fingerprint) : std::string_view();
  channel.known = !type.empty();
  channel.type = channel.known ? std::string(type) : head ? Hex(head->fingerprint) : "??";
  if (!channel.known) return;
  if (!messaging::CheckMessage(type, event.bytes).ok()) {
    ++channel.undecodable;
    return;
  }
  channel.lost += statistics->CountReceived(event.channel, head->seq, size);
  if (event.channel == messaging::kGeonSession) AddSession(event, summary);
}

std::string Line(const std::string& name, const LogChannel& channel) {
  char text[200];
  std::snprintf(text, sizeof(text), "%-26s %-18s %8lld %9.1f %11.1f %7lld %9.2f\n", name.c_str(),
                channel.type.c_str(), static_cast<long long>(channel.events), channel.RateHz(),
                static_cast<double>(channel.bytes) / 1e3, static_cast<long long>(channel.lost),
                SecondsFromMicroseconds(channel.longest_gap_us));
  return text;
}

}  // namespace

double LogChannel::RateHz() const {
  const double span_s = SecondsFromMicroseconds(last_utime - first_utime);
  return events > 1 && span_s > 0.0 ? static_cast<double>(events - 1) / span_s : 0.0;
}

double LogSummary::SpanSeconds() const { return SecondsFromMicroseconds(last_utime - first_utime); }

int64_t LogSummary::Lost() const {
  int64_t sum = 0;
  for (const auto& [name, channel] : channels) sum += channel.lost;
  return sum;
}

std::string LogSummary::Complaint() const {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  if (damage.any()) add(messaging::Describe(damage));
  if (events == 0) add("no events");
  for (const auto& [name, channel] : channels) {
    if (channel.undecodable > 0) {
      add(std::to_string(channel.undecodable) + " message(s) on " + name + " do not decode");
    }
    if (!channel.known) add("channel " + name + " carries a type that is none of ours");
  }
  return text;
}

Result<LogSummary> SummarizeLog(const std::filesystem::path& file) {
  Result<messaging::LogReader> log = messaging::LogReader::Open(file);
  if (!log.ok()) return log.status();
  LogSummary summary;
  summary.file = file;
  summary.file_bytes = log->file_bytes();
  messaging::BusStatistics statistics;
  while (const std::optional<LogEvent> event = log->Next()) AddEvent(*event, &statistics, &summary);
  summary.damage = log->damage();
  return summary;
}

nlohmann::ordered_json ToJson(const LogSummary& summary) {
  nlohmann::ordered_json json = {{"file", summary.file.string()},
                                 {"whole", summary.Complaint().empty()},
                                 {"complaint", summary.Complaint()},
                                 {"bytes", summary.file_bytes},
                                 {"events", summary.events},
                                 {"first_utime", summary.first_utime},
                                 {"span_s", summary.SpanSeconds()},
                                 {"lost", summary.Lost()},
                                 {"skipped_bytes", summary.damage.skipped_bytes},
                                 {"missing_events", summary.damage.missing_events},
                                 {"torn_tail_bytes", summary.damage.torn_tail_bytes},
                                 {"versions", summary.versions},
                                 {"foreign_sessions", summary.foreign_sessions},
                                 {"channels", nlohmann::ordered_json::array()}};
  for (const auto& [name, channel] : summary.channels) {
    json["channels"].push_back(
        {{"channel", name},
         {"type", channel.type},
         {"known", channel.known},
         {"events", channel.events},
         {"rate_hz", channel.RateHz()},
         {"bytes", channel.bytes},
         {"lost", channel.lost},
         {"undecodable", channel.undecodable},
         {"longest_gap_s", SecondsFromMicroseconds(channel.longest_gap_us)}});
  }
  return json;
}

std::string ToText(const LogSummary& summary) {
  char text[300];
  std::snprintf(
      text, sizeof(text), "%s: %lld events, %.1f s, %.2f MB, %lld message(s) lost by seq\n",
      summary.file.c_str(), static_cast<long long>(summary.events), summary.SpanSeconds(),
      static_cast<double>(summary.file_bytes) / 1e6, static_cast<long long>(summary.Lost()));
  std::string lines = text;
  for (const std::string& version : summary.versions)
    lines += "written by version " + version + "\n";
  if (summary.foreign_sessions > 0) lines += "some programs were built from other message types\n";
  std::snprintf(text, sizeof(text), "%-26s %-18s %8s %9s %11s %7s %9s\n", "channel", "type",
                "events", "rate_hz", "kB", "lost", "gap_s");
  lines += text;
  for (const auto& [name, channel] : summary.channels) lines += Line(name, channel);
  const std::string complaint = summary.Complaint();
  return lines + (complaint.empty() ? "whole\n" : "NOT WHOLE: " + complaint + "\n");
}

}  // namespace geon::cli
