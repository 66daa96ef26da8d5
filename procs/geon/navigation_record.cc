#include "procs/geon/navigation_record.h"

#include <algorithm>
#include <cstdio>

#include "procs/geon/experiment_json.h"
#include "procs/geon/join_shards.h"
#include "procs/geon/spread.h"

namespace geon::cli {
namespace {

using lockstep::NavigationEnd;
using nlohmann::json;

json ToJson(const NavigationTrialRecord& trial) {
  json value = {{"t", trial.t},
                {"world", trial.world},
                {"seed", trial.seed},
                {"expected", ToString(trial.expected)},
                {"end", ToString(trial.end)},
                {"why", trial.why},
                {"first_sight_s", OptionalJson(trial.first_sight_s)},
                {"end_s", trial.end_s},
                {"contacts", trial.contacts},
                {"hardest_contact_m_s", trial.hardest_contact_m_s},
                {"path_m", trial.path_m}};
  if (trial.course) {
    value["course"] = {{"id", trial.course->id},
                       {"shortest_m", trial.course->shortest_m},
                       {"optimal_s", trial.course->optimal_s},
                       {"left_m", trial.course->left_m},
                       {"length_ratio_1", trial.length_ratio_1()},
                       {"barn_score_1", trial.barn_score_1()}};
  }
  return value;
}

NavigationTrialRecord ParseNavigationTrial(const json& value) {
  NavigationTrialRecord trial;
  trial.t = value.at("t");
  trial.world = value.at("world");
  trial.seed = value.at("seed");
  trial.expected =
      lockstep::NavigationEndFromString(value.at("expected").get<std::string>()).value();
  trial.end = lockstep::NavigationEndFromString(value.at("end").get<std::string>()).value();
  trial.why = value.at("why");
  trial.first_sight_s = ParseOptional(value.at("first_sight_s"));
  trial.end_s = value.at("end_s");
  trial.contacts = value.at("contacts");
  trial.hardest_contact_m_s = value.at("hardest_contact_m_s");
  trial.path_m = value.at("path_m");
  if (value.contains("course")) {
    const json& course = value.at("course");
    trial.course = CourseRecord{course.at("id"), course.at("shortest_m"), course.at("optimal_s"),
                                course.at("left_m")};
  }
  return trial;
}

json RatesOf(const NavigationSummary& summary) {
  json rates = {{"runs", summary.runs},
                {"right", summary.right},
                {"reached", summary.reached},
                {"contacts", summary.contacts},
                {"hardest_contact_m_s", summary.hardest_contact_m_s},
                {"trapped", summary.trapped},
                {"unreachable", summary.unreachable},
                {"none_found", summary.none_found},
                {"time_s", SpreadJson(summary.times_s)}};
  if (summary.barn_score_1) {
    rates["length_ratio_1"] = OptionalJson(summary.length_ratio_1);
    rates["barn_score_1"] = OptionalJson(summary.barn_score_1);
  }
  return rates;
}

json RatesJson(const NavigationRecord& record) {
  json rates = RatesOf(Summarize(record));
  json worlds = json::object();
  for (const std::string& world : WorldsOf(record)) {
    worlds[world] = RatesOf(Summarize(record, world));
  }
  rates["worlds"] = worlds;
  return rates;
}

bool HasCourses(const NavigationRecord& record) {
  return !record.trials.empty() && record.trials.front().course.has_value();
}

std::string Row(const std::string& name, const NavigationSummary& summary) {
  const auto spread = SpreadOf(summary.times_s);
  char text[200];
  std::snprintf(text, sizeof text, "%-16s%8d%8d%9d%13d%12d%9d%10d%9.2f", name.c_str(), summary.runs,
                summary.right, summary.reached, summary.unreachable, summary.none_found,
                summary.trapped, summary.contacts, summary.hardest_contact_m_s);
  std::string row = text;
  if (spread) {
    std::snprintf(text, sizeof text, "%9.1f%8.1f%8.1f", spread->p50, spread->p95, spread->max);
    row += text;
  }
  if (spread && summary.length_ratio_1 && summary.barn_score_1) {
    std::snprintf(text, sizeof text, "%9.3f%8.3f", *summary.length_ratio_1, *summary.barn_score_1);
    row += text;
  }
  return row + "\n";
}

}  // namespace

double NavigationTrialRecord::barn_score_1() const {
  if (end != NavigationEnd::kReached) return 0.0;
  return course->optimal_s / std::clamp(end_s, 2.0 * course->optimal_s, 8.0 * course->optimal_s);
}

std::vector<std::string> WorldsOf(const NavigationRecord& record) {
  std::vector<std::string> worlds;
  for (const NavigationTrialRecord& trial : record.trials) {
    if (std::find(worlds.begin(), worlds.end(), trial.world) == worlds.end()) {
      worlds.push_back(trial.world);
    }
  }
  return worlds;
}

NavigationSummary Summarize(const NavigationRecord& record, const std::string& world) {
  NavigationSummary summary;
  int courses = 0, arrived = 0;
  double ratios_1 = 0.0, scores_1 = 0.0;
  for (const NavigationTrialRecord& trial : record.trials) {
    if (!world.empty() && trial.world != world) continue;
    ++summary.runs;
    summary.right += trial.right() ? 1 : 0;
    summary.reached += trial.end == NavigationEnd::kReached ? 1 : 0;
    summary.unreachable += trial.end == NavigationEnd::kUnreachable ? 1 : 0;
    summary.none_found += trial.end == NavigationEnd::kNoneFound ? 1 : 0;
    summary.trapped += trial.end == NavigationEnd::kTrapped ? 1 : 0;
    summary.contacts += trial.contacts;
    summary.hardest_contact_m_s = std::max(summary.hardest_contact_m_s, trial.hardest_contact_m_s);
    if (trial.course) {
      ++courses;
      scores_1 += trial.barn_score_1();
    }
    if (trial.end != NavigationEnd::kReached) continue;
    if (trial.course) {
      ++arrived;
      ratios_1 += trial.length_ratio_1();
      summary.times_s.push_back(trial.end_s);
    } else if (trial.first_sight_s) {
      summary.times_s.push_back(trial.end_s - *trial.first_sight_s);
    }
  }
  if (courses > 0) summary.barn_score_1 = scores_1 / courses;
  if (arrived > 0) summary.length_ratio_1 = ratios_1 / arrived;
  return summary;
}

std::string NavigationRecordText(const NavigationRecord& record) {
  json trials = json::array(), maps = json::array();
  for (const NavigationTrialRecord& trial : record.trials) trials.push_back(ToJson(trial));
  for (const DrawnRun& run : record.maps) maps.push_back(ToJson(run));
  return json{{"format", kExperimentFormat},
              {"experiment", kNavigationExperiment},
              {"method", record.planner},
              {"seed", record.seed},
              {"git", record.git},
              {"conditions", record.conditions},
              {"trials", trials},
              {"maps", maps},
              {"rates", RatesJson(record)},
              {"seconds", nullptr}}
             .dump() +
         "\n";
}

Result<NavigationRecord> ParseNavigationRecord(const json& value, const std::string& name) {
  try {
    if (value.at("format") != kExperimentFormat ||
        value.at("experiment") != kNavigationExperiment) {
      return Status::Error(name + ": not the results of geon experiment navigation");
    }
    NavigationRecord record;
    record.planner = value.at("method");
    record.seed = value.at("seed");
    record.git = value.at("git");
    record.conditions = value.at("conditions");
    for (const json& trial : value.at("trials"))
      record.trials.push_back(ParseNavigationTrial(trial));
    for (const json& run : value.at("maps")) AddDrawnRun(ParseDrawnRun(run), &record.maps);
    return record;
  } catch (const std::exception& error) {
    return Status::Error(name + ": damaged results: " + error.what());
  }
}

Result<NavigationRecord> MergeNavigationRecords(const std::vector<NavigationRecord>& shards) {
  return JoinShards(
      shards, &NavigationRecord::trials,
      [](const NavigationRecord& a, const NavigationRecord& b) {
        return a.planner == b.planner && a.seed == b.seed && a.git == b.git &&
               a.conditions == b.conditions;
      },
      [](const NavigationRecord& shard, NavigationRecord* all) {
        for (const DrawnRun& run : shard.maps) AddDrawnRun(run, &all->maps);
      });
}

std::string NavigationTables(const NavigationRecord& record) {
  std::string text =
      "planner " + record.planner + ", sensors " + record.conditions.value("sensors", "") +
      "; times in s, from the " +
      (HasCourses(record) ? "start to the destination" : "first sight to the place to look from") +
      "\nworld               runs   right  reached  unreachable  none found  trapped"
      "  contacts  at m/s   median     95 %     max" +
      (HasCourses(record) ? "   length   score\n" : "\n");
  const std::vector<std::string> worlds = WorldsOf(record);
  constexpr size_t kMostRows = 40;
  for (size_t k = 0; k < std::min(worlds.size(), kMostRows); ++k) {
    text += Row(worlds[k], Summarize(record, worlds[k]));
  }
  if (worlds.size() > kMostRows) {
    text += "(" + std::to_string(worlds.size() - kMostRows) + " more in results.json)\n";
  }
  if (worlds.size() > 1) text += Row("all", Summarize(record));
  return text;
}

}  // namespace geon::cli
