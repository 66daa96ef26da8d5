#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>

#include "base/status.h"
#include "messaging/bus_statistics.h"
#include "messaging/log_reader.h"

namespace geon::cli {

struct LogChannel {
  std::string type;  // "stripe_t", or the fingerprint of a type that is none of ours
  bool known = false;
  int64_t events = 0;
  int64_t bytes = 0;
  int64_t lost = 0;         // holes in seq
  int64_t undecodable = 0;  // ours by fingerprint, but not by content
  int64_t first_utime = 0;
  int64_t last_utime = 0;
  int64_t longest_gap_us = 0;
  // Events a second between the first and the last; 0 for fewer than two.
  double RateHz() const;
};

// What a log holds and whether it is whole.
struct LogSummary {
  std::filesystem::path file;
  int64_t file_bytes = 0;
  int64_t events = 0;
  int64_t first_utime = 0;
  int64_t last_utime = 0;
  std::map<std::string, LogChannel> channels;
  std::set<std::string> versions;  // of the programs that wrote it (GEON_SESSION)
  int64_t foreign_sessions = 0;    // from programs built from other types
  messaging::LogDamage damage;

  double SpanSeconds() const;
  int64_t Lost() const;
  // Why the log is not good; empty when it is. Lost messages are a fact of the run, not damage of
  // the log.
  std::string Complaint() const;
};

Result<LogSummary> SummarizeLog(const std::filesystem::path& file);
nlohmann::ordered_json ToJson(const LogSummary& summary);
// For people: a table.
std::string ToText(const LogSummary& summary);

}  // namespace geon::cli
