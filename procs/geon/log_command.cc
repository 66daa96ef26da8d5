#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>

#include "messaging/log_reader.h"
#include "messaging/message_schema.h"
#include "procs/geon/commands.h"
#include "procs/geon/log_summary.h"

namespace geon::cli {
namespace {

struct LogArguments {
  std::string file;
  std::string channel = ".*";
  bool json = false;
};

int FailedToReadLog(const Status& status) {
  std::cerr << "geon log: " << status.message() << '\n';
  return kFailed;
}

int Info(const LogArguments& arguments) {
  const Result<LogSummary> summary = SummarizeLog(arguments.file);
  if (!summary.ok()) return FailedToReadLog(summary.status());
  std::cout << (arguments.json ? ToJson(*summary).dump() + "\n" : ToText(*summary));
  return summary->Complaint().empty() ? kOk : kFailed;
}

int Check(const LogArguments& arguments) {
  const Result<LogSummary> summary = SummarizeLog(arguments.file);
  if (!summary.ok()) return FailedToReadLog(summary.status());
  const std::string complaint = summary->Complaint();
  if (arguments.json) {
    std::cout << ToJson(*summary).dump() << '\n';
  } else {
    std::cout << arguments.file << ": " << (complaint.empty() ? "whole" : complaint) << '\n';
  }
  return complaint.empty() ? kOk : kFailed;
}

// One event as a line of JSON; image bytes are left out.
nlohmann::ordered_json EventJson(const messaging::LogEvent& event) {
  nlohmann::ordered_json line = {{"utime", event.utime}, {"channel", event.channel}};
  const auto head = messaging::ReadMessageHead(event.bytes);
  line["type"] = head ? std::string(messaging::TypeNameOf(head->fingerprint)) : std::string();
  const auto message = messaging::MessageToJson(event.bytes);
  if (message.ok()) {
    line["message"] = *message;
  } else {
    line["error"] = message.message();
  }
  return line;
}

int Export(const LogArguments& arguments) {
  Result<messaging::LogReader> log = messaging::LogReader::Open(arguments.file);
  if (!log.ok()) return FailedToReadLog(log.status());
  const std::regex channel(arguments.channel);
  while (const std::optional<messaging::LogEvent> event = log->Next()) {
    if (!std::regex_match(event->channel, channel)) continue;
    // Text of a foreign program need not be UTF-8.
    std::cout << EventJson(*event).dump(-1, ' ', false,
                                        nlohmann::ordered_json::error_handler_t::replace)
              << '\n';
  }
  if (!log->damage().any()) return kOk;
  return FailedToReadLog(Status::Error(arguments.file + ": " + messaging::Describe(log->damage())));
}

}  // namespace

void AddLogCommand(CLI::App& app, int* exit_code) {
  auto arguments = std::make_shared<LogArguments>();
  CLI::App* log = app.add_subcommand("log", "look into a recording (LCM log)");
  log->require_subcommand(1);
  const auto add = [&](const char* name, const char* purpose, int (*run)(const LogArguments&)) {
    CLI::App* command = log->add_subcommand(name, purpose);
    command->add_option("LOG", arguments->file, "file written by scripts/record or lcm-logger")
        ->required()
        ->check(CLI::ExistingFile);
    command->callback([=] { *exit_code = run(*arguments); });
    return command;
  };
  add("info", "channels, types, rates, losses, span; exit 1 if the log is damaged", Info)
      ->add_flag("--json", arguments->json, "one JSON object");
  add("check", "whether the log is whole; exit 1 if it is damaged", Check)
      ->add_flag("--json", arguments->json, "one JSON object");
  CLI::App* exporting =
      add("export", "every message as a line of JSON, without image bytes", Export);
  exporting->add_option("--channel", arguments->channel, "regular expression of whole names");
  exporting->add_flag("--json", arguments->json, "accepted: the output is JSON in any case");
}

}  // namespace geon::cli
