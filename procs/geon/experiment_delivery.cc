#include <iostream>
#include <nlohmann/json.hpp>

#include "config/text_file.h"
#include "procs/geon/commands.h"
#include "procs/geon/experiment_commands.h"

namespace geon::cli {
namespace {

Status WriteTexts(const RecordTexts& texts, double seconds,
                  const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) return Status::Error(directory.string() + ": " + error.message());
  const nlohmann::json timing = {{"seconds", seconds}};
  const std::pair<const char*, std::string> files[] = {{"results.json", texts.json},
                                                       {"timing.json", timing.dump() + "\n"},
                                                       {"report.html", texts.page}};
  for (const auto& [name, text] : files) {
    const Status written = config::WriteFileAtomically(directory / name, text);
    if (!written.ok()) return written;
  }
  return Status::Ok();
}

std::string CheckShard(const std::string& text) {
  int index = 0, count = 0;
  const bool good = ReadNumberPair(text, '/', &index, &count) && index >= 1 && index <= count;
  return good ? "" : "must be i/n, i from 1 to n";
}

}  // namespace

bool ReadNumberPair(const std::string& text, char sign, int* first, int* second) {
  const size_t place = text.find(sign);
  return place != std::string::npos && CLI::detail::lexical_cast(text.substr(0, place), *first) &&
         CLI::detail::lexical_cast(text.substr(place + 1), *second);
}

Shard ParseShard(const std::string& text) {
  Shard shard;
  ReadNumberPair(text, '/', &shard.index, &shard.count);
  return shard;
}

void AddSpreadArguments(CLI::App& command, std::string* shard, int* jobs) {
  command.add_option("--shard", *shard, "i/n: every n-th trial, from the i-th")
      ->check(CheckShard)
      ->capture_default_str();
  command.add_option("--jobs", *jobs, "trials run at a time")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
}

int DeliverText(const RecordTexts& texts, double seconds, bool json,
                const std::filesystem::path& output) {
  std::cout << (json ? texts.json : texts.tables) << std::flush;
  if (output.empty()) return kOk;
  const Status written = WriteTexts(texts, seconds, output);
  if (!written.ok()) {
    std::cerr << "geon experiment: " << written.message() << '\n';
    return kFailed;
  }
  std::cerr << "geon experiment: wrote " << (output / "report.html").string() << '\n';
  return kOk;
}

}  // namespace geon::cli
