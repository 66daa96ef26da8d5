#include "procs/geon/robot_record.h"

#include <algorithm>

#include "procs/geon/experiment_json.h"
#include "procs/geon/experiment_rates.h"
#include "procs/geon/join_shards.h"
#include "procs/geon/spread.h"

namespace geon::cli {
namespace {

nlohmann::json GeonsJson(const std::vector<RobotGeonRecord>& geons) {
  nlohmann::json value = nlohmann::json::array();
  for (const RobotGeonRecord& geon : geons) {
    value.push_back({{"truth", ToString(geon.truth)},
                     {"place", geon.place},
                     {"found", geon.found},
                     {"label", LabelJson(geon.label)},
                     {"decided", geon.decided},
                     {"views", geon.views},
                     {"off_m", geon.off_m}});
  }
  return value;
}

std::vector<RobotGeonRecord> ParseGeons(const nlohmann::json& value) {
  std::vector<RobotGeonRecord> geons;
  for (const nlohmann::json& each : value) {
    geons.push_back({ParseLabel(each.at("truth")), each.at("place"), each.at("found"),
                     ParseOptionalLabel(each.at("label")), each.at("decided"), each.at("views"),
                     each.at("off_m")});
  }
  return geons;
}

nlohmann::json ToJson(const RobotTrialRecord& trial) {
  return {{"t", trial.t},
          {"seed", trial.seed},
          {"world", trial.world.empty() ? nlohmann::json() : nlohmann::json(trial.world)},
          {"place", trial.subject.object},
          {"position", trial.subject.position},
          {"truth", ToString(trial.subject.truth)},
          {"end", ToString(trial.end)},
          {"label", LabelJson(trial.label)},
          {"confidence", trial.confidence},
          {"decided", trial.decided},
          {"views", trial.views},
          {"why", trial.why},
          {"first_sight_s", OptionalJson(trial.first_sight_s)},
          {"end_s", trial.end_s},
          {"contacts", trial.contacts},
          {"hardest_contact_m_s", trial.hardest_contact_m_s},
          {"path_m", trial.path_m},
          {"geons", GeonsJson(trial.geons)},
          {"others", trial.others}};
}

RobotTrialRecord ParseRobotTrial(const nlohmann::json& value) {
  RobotTrialRecord trial;
  trial.t = value.at("t");
  trial.seed = value.at("seed");
  if (!value.at("world").is_null()) trial.world = value.at("world");
  trial.subject = {ParseLabel(value.at("truth")), value.at("place"), value.at("position")};
  trial.end = sensor::MissionOutcomeFromString(value.at("end").get<std::string>()).value();
  trial.label = ParseOptionalLabel(value.at("label"));
  trial.confidence = value.at("confidence");
  trial.decided = value.at("decided");
  trial.views = value.at("views");
  trial.why = value.at("why");
  trial.first_sight_s = ParseOptional(value.at("first_sight_s"));
  trial.end_s = value.at("end_s");
  trial.contacts = value.at("contacts");
  trial.hardest_contact_m_s = value.at("hardest_contact_m_s");
  trial.path_m = value.at("path_m");
  trial.geons = ParseGeons(value.at("geons"));
  trial.others = value.at("others");
  return trial;
}

nlohmann::json ToJson(const RobotFilm& film) {
  nlohmann::json stills = nlohmann::json::array();
  for (const RobotFilm::Still& still : film.stills) {
    stills.push_back({{"time_s", still.time_s},
                      {"phase", still.phase},
                      {"text", still.text},
                      {"place_m", PointJson(still.place_m)},
                      {"picture", still.picture_uri}});
  }
  return {{"run", ToJson(film.run)}, {"stills", stills}};
}

RobotFilm ParseFilm(const nlohmann::json& value) {
  RobotFilm film;
  film.run = ParseDrawnRun(value.at("run"));
  for (const nlohmann::json& still : value.at("stills")) {
    film.stills.push_back({still.at("time_s"), still.at("phase"), still.at("text"),
                           ParsePoint(still.at("place_m")), still.at("picture")});
  }
  return film;
}

nlohmann::json RobotCells(const RobotRecord& record) {
  std::vector<Answer> answers;
  for (const RobotTrialRecord& trial : record.trials) {
    answers.push_back({trial.subject, std::nullopt, trial.label, trial.decided});
  }
  return AnswerCells(answers);
}

nlohmann::json RobotRatesOf(const RobotSummary& summary) {
  nlohmann::json rates = RateJson(summary.right);
  rates["runs"] = summary.right.n;
  rates["wrong"] = summary.wrong;
  rates["undecided"] = summary.undecided;
  rates["right_guess"] = summary.right_guesses;
  rates["reached"] = summary.times_s.size();
  rates["trapped"] = summary.trapped;
  rates["unreachable"] = summary.unreachable;
  rates["contacts"] = summary.contacts;
  rates["hardest_contact_m_s"] = summary.hardest_contact_m_s;
  rates["time_s"] = SpreadJson(summary.times_s);
  rates["views"] = summary.views;
  rates["geons"] = RateJson(summary.geons);
  rates["others"] = summary.others;
  rates["off_m"] = SpreadJson(summary.off_m);
  return rates;
}

nlohmann::json RobotRates(const RobotRecord& record) {
  nlohmann::json rates = RobotRatesOf(Summarize(record));
  rates["places"] = nlohmann::json::object();
  for (const std::string& place : PlacesOf(record)) {
    rates["places"][place] = RobotRatesOf(Summarize(record, place));
  }
  return rates;
}

}  // namespace

RobotSummary Summarize(const RobotRecord& record, const std::string& place) {
  RobotSummary summary;
  for (const RobotTrialRecord& trial : record.trials) {
    if (!place.empty() && trial.subject.object != place) continue;
    summary.right.Count(trial.right());
    summary.wrong += trial.concluded() && !trial.right() ? 1 : 0;
    summary.undecided += trial.reached() && !trial.concluded() ? 1 : 0;
    summary.right_guesses += trial.right_guess() ? 1 : 0;
    summary.trapped += trial.trapped() ? 1 : 0;
    summary.unreachable += trial.unreachable() && !trial.reached() ? 1 : 0;
    summary.contacts += trial.contacts;
    summary.hardest_contact_m_s = std::max(summary.hardest_contact_m_s, trial.hardest_contact_m_s);
    if (trial.reached()) summary.times_s.push_back(trial.end_s);
    summary.others += trial.others;
    for (const RobotGeonRecord& geon : trial.geons) {
      summary.geons.Count(geon.right());
      if (geon.found) summary.off_m.push_back(geon.off_m);
    }
    if (trial.views == 0) continue;
    const auto views = static_cast<size_t>(trial.views);
    if (summary.views.size() < views) summary.views.resize(views, 0);
    ++summary.views[views - 1];
  }
  return summary;
}

std::vector<std::string> PlacesOf(const RobotRecord& record) {
  std::vector<std::string> places;
  for (const char* place : {"floor", "box"}) {
    if (std::any_of(record.trials.begin(), record.trials.end(),
                    [&](const auto& trial) { return trial.subject.object == place; })) {
      places.emplace_back(place);
    }
  }
  return places;
}

std::string RobotRecordText(const RobotRecord& record) {
  nlohmann::json trials = nlohmann::json::array(), maps = nlohmann::json::array();
  for (const RobotTrialRecord& trial : record.trials) trials.push_back(ToJson(trial));
  for (const DrawnRun& run : record.maps) maps.push_back(ToJson(run));
  return nlohmann::json{{"format", kExperimentFormat},
                        {"experiment", kRobotExperiment},
                        {"method", record.method},
                        {"seed", record.seed},
                        {"git", record.git},
                        {"conditions", record.conditions},
                        {"cells", RobotCells(record)},
                        {"trials", trials},
                        {"maps", maps},
                        {"film", record.film ? ToJson(*record.film) : nlohmann::json()},
                        {"rates", RobotRates(record)},
                        {"seconds", nullptr}}
             .dump() +
         "\n";
}

Result<RobotRecord> ParseRobotRecord(const nlohmann::json& value, const std::string& name) {
  try {
    if (value.at("format") != kExperimentFormat || value.at("experiment") != kRobotExperiment) {
      return Status::Error(name + ": not the results of geon experiment robot");
    }
    RobotRecord record;
    record.method = value.at("method");
    record.seed = value.at("seed");
    record.git = value.at("git");
    record.conditions = value.at("conditions");
    for (const nlohmann::json& trial : value.at("trials"))
      record.trials.push_back(ParseRobotTrial(trial));
    for (const nlohmann::json& run : value.at("maps"))
      AddDrawnRun(ParseDrawnRun(run), &record.maps);
    if (!value.at("film").is_null()) record.film = ParseFilm(value.at("film"));
    return record;
  } catch (const std::exception& error) {
    return Status::Error(name + ": damaged results: " + error.what());
  }
}

Result<RobotRecord> MergeRobotRecords(const std::vector<RobotRecord>& shards) {
  return JoinShards(
      shards, &RobotRecord::trials,
      [](const RobotRecord& a, const RobotRecord& b) {
        return a.method == b.method && a.seed == b.seed && a.git == b.git &&
               a.conditions == b.conditions;
      },
      [](const RobotRecord& shard, RobotRecord* all) {
        for (const DrawnRun& run : shard.maps) AddDrawnRun(run, &all->maps);
        if (shard.film) all->film = shard.film;
      });
}

}  // namespace geon::cli
