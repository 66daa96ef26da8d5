#include "procs/geon/experiment_color_record.h"

#include <algorithm>
#include <functional>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include "base/median.h"
#include "base/plain_name.h"
#include "procs/geon/experiment_json.h"
#include "procs/geon/experiment_rates.h"
#include "procs/geon/join_shards.h"
#include "procs/geon/svg.h"

namespace geon::cli {
namespace {

using nlohmann::json;

constexpr size_t kMostWorstPictures = 12;

auto Badness(const WorstPicture& picture) {
  return std::tuple(picture.score.found, picture.score.iou_1, picture.t);
}

ColorRow RowOf(const std::string& name, const ColorRecord& record,
               const std::function<bool(const ColorOutcome&)>& belongs) {
  ColorRow row;
  row.name = name;
  for (size_t method = 0; method < record.methods.size(); ++method) {
    evaluation::SuccessRate found;
    std::vector<double> ious_1;
    for (const ColorOutcome& outcome : record.outcomes) {
      if (!belongs(outcome)) continue;
      found.Count(outcome.scores[method].found);
      ious_1.push_back(outcome.scores[method].iou_1);
    }
    row.found.push_back(found);
    row.median_iou_1.push_back(Median(std::move(ious_1)));
  }
  return row;
}

// A row for each value that `value` has among the outcomes, in the order of the values.
template <typename Value, typename Name>
std::vector<ColorRow> RowsBy(const ColorRecord& record, Value value, Name name) {
  std::vector<decltype(value(record.outcomes.front()))> values;
  for (const ColorOutcome& outcome : record.outcomes) values.push_back(value(outcome));
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  std::vector<ColorRow> rows;
  for (const auto& each : values) {
    rows.push_back(RowOf(name(each), record,
                         [&](const ColorOutcome& outcome) { return value(outcome) == each; }));
  }
  return rows;
}

json RowJson(const ColorRow& row, size_t method) {
  json rate = RateJson(row.found[method], "found");
  rate["median_iou"] = row.median_iou_1[method];
  return rate;
}

json ColorRatesJson(const ColorRecord& record) {
  json rates = json::object();
  for (const auto& [heading, rows] : ColorRows(record)) {
    for (const ColorRow& row : rows) {
      for (size_t method = 0; method < record.methods.size(); ++method) {
        json& of_method = rates[record.methods[method]];
        (heading.empty() ? of_method[row.name] : of_method[heading][row.name]) =
            RowJson(row, method);
      }
    }
  }
  return rates;
}

json CellsJson(const ColorRecord& record) {
  json cells = json::array();
  for (const ColorRow& row : RowsBy(
           record, [](const ColorOutcome& each) { return each.label; },
           [](GeonLabel label) { return std::string(ToString(label)); })) {
    cells.push_back({{"truth", row.name}, {"n", row.found[0].n}, {"found", row.found[0].right}});
  }
  return cells;
}

json TrialJson(const ColorOutcome& outcome) {
  json scores = json::array();
  for (const ColorScore& score : outcome.scores) {
    scores.push_back({{"found", score.found}, {"iou", score.iou_1}});
  }
  return {{"t", outcome.t},
          {"truth", ToString(outcome.label)},
          {"kelvin", outcome.kelvin},
          {"stops", outcome.stops},
          {"light", outcome.light},
          {"distractors", outcome.distractors},
          {"target_pixels", outcome.target_pixels},
          {"exposure", outcome.exposure_1},
          {"scores", scores}};
}

ColorOutcome ParseTrial(const json& value, size_t methods) {
  ColorOutcome outcome;
  outcome.t = value.at("t");
  outcome.label = ParseLabel(value.at("truth"));
  outcome.kelvin = value.at("kelvin");
  outcome.stops = value.at("stops");
  outcome.light = value.at("light");
  outcome.distractors = value.at("distractors");
  outcome.target_pixels = value.at("target_pixels");
  outcome.exposure_1 = value.at("exposure");
  for (const json& score : value.at("scores")) {
    outcome.scores.push_back({score.at("found"), score.at("iou")});
  }
  if (outcome.scores.size() != methods) {
    throw std::runtime_error("trial " + std::to_string(outcome.t) + " has not a score a method");
  }
  return outcome;
}

void PrintTable(const ColorRecord& record, const std::string& title,
                const std::function<std::string(const ColorRow&, size_t)>& cell,
                std::ostringstream* out) {
  constexpr int kNameWidth = 20, kCellWidth = 22;
  *out << title << "\n" << std::left << std::setw(kNameWidth) << "" << std::right;
  for (const std::string& method : record.methods) *out << std::setw(kCellWidth) << method;
  *out << "\n";
  for (const auto& [heading, rows] : ColorRows(record)) {
    if (!heading.empty()) *out << heading << "\n";
    for (const ColorRow& row : rows) {
      *out << std::left << std::setw(kNameWidth) << "  " + row.name << std::right;
      for (size_t method = 0; method < record.methods.size(); ++method) {
        *out << std::setw(kCellWidth) << cell(row, method);
      }
      *out << "\n";
    }
  }
}

}  // namespace

bool IsAmongWorst(const WorstPicture& picture, const std::vector<WorstPicture>& worst) {
  return worst.size() < kMostWorstPictures || Badness(picture) < Badness(worst.back());
}

void AddWorstPicture(WorstPicture picture, std::vector<WorstPicture>* worst) {
  const auto place = std::find_if(worst->begin(), worst->end(), [&](const WorstPicture& each) {
    return Badness(picture) < Badness(each);
  });
  worst->insert(place, std::move(picture));
  if (worst->size() > kMostWorstPictures) worst->pop_back();
}

std::vector<std::pair<std::string, std::vector<ColorRow>>> ColorRows(const ColorRecord& record) {
  if (record.outcomes.empty()) return {};
  const auto plain = [](const std::string& name) { return name; };
  return {{"", {RowOf("all", record, [](const ColorOutcome&) { return true; })}},
          {"colour of the lamp", RowsBy(
                                     record, [](const ColorOutcome& each) { return each.kelvin; },
                                     [](int kelvin) { return std::to_string(kelvin) + " K"; })},
          {"level of the light",
           RowsBy(
               record, [](const ColorOutcome& each) { return each.stops; },
               [](int stops) { return (stops > 0 ? "+" : "") + std::to_string(stops) + " EV"; })},
          {"light", RowsBy(
                        record, [](const ColorOutcome& each) { return each.light; }, plain)},
          {"beside the target",
           RowsBy(
               record, [](const ColorOutcome& each) { return each.distractors; },
               [](bool reddish) { return std::string(reddish ? "red-ish things" : "plain"); })},
          {"geon", RowsBy(
                       record, [](const ColorOutcome& each) { return each.label; },
                       [](GeonLabel label) { return PlainName(label); })}};
}

std::string ColorRecordText(const ColorRecord& record) {
  json trials = json::array(), worst = json::array();
  for (const ColorOutcome& outcome : record.outcomes) trials.push_back(TrialJson(outcome));
  for (const WorstPicture& picture : record.worst) {
    worst.push_back({{"t", picture.t}, {"picture", picture.data_uri}});
  }
  return json{{"format", kExperimentFormat},
              {"experiment", kColorExperiment},
              {"method", record.methods.front()},
              {"methods", record.methods},
              {"model", record.model},
              {"seed", record.seed},
              {"git", record.git},
              {"conditions", record.conditions},
              {"cells", CellsJson(record)},
              {"trials", trials},
              {"worst", worst},
              {"rates", ColorRatesJson(record)},
              {"seconds", nullptr}}
             .dump() +
         "\n";
}

Result<ColorRecord> ParseColorRecord(const json& value, const std::string& name) {
  try {
    if (value.at("format") != kExperimentFormat || value.at("experiment") != kColorExperiment) {
      return Status::Error(name + ": not the results of geon experiment color");
    }
    ColorRecord record;
    record.seed = value.at("seed");
    record.git = value.at("git");
    record.conditions = value.at("conditions");
    record.methods = value.at("methods").get<std::vector<std::string>>();
    record.model = value.at("model");
    if (record.methods.empty()) throw std::runtime_error("no methods");
    for (const json& trial : value.at("trials")) {
      record.outcomes.push_back(ParseTrial(trial, record.methods.size()));
    }
    for (const json& picture : value.at("worst")) {
      const int t = picture.at("t");
      const auto trial = std::find_if(record.outcomes.begin(), record.outcomes.end(),
                                      [t](const ColorOutcome& each) { return each.t == t; });
      if (trial == record.outcomes.end()) {
        throw std::runtime_error("a picture of trial " + std::to_string(t) +
                                 ", which is not there");
      }
      AddWorstPicture({t, trial->scores.front(), picture.at("picture")}, &record.worst);
    }
    return record;
  } catch (const std::exception& error) {
    return Status::Error(name + ": damaged results: " + error.what());
  }
}

Result<ColorRecord> MergeColorRecords(const std::vector<ColorRecord>& shards) {
  return JoinShards(
      shards, &ColorRecord::outcomes,
      [](const ColorRecord& a, const ColorRecord& b) {
        return a.seed == b.seed && a.git == b.git && a.conditions == b.conditions &&
               a.methods == b.methods && a.model == b.model;
      },
      [](const ColorRecord& shard, ColorRecord* all) {
        for (const WorstPicture& picture : shard.worst) AddWorstPicture(picture, &all->worst);
      });
}

std::string ColorTables(const ColorRecord& record) {
  std::ostringstream out;
  out << "colour in " << record.outcomes.size() << " rendered pictures\n\n";
  PrintTable(
      record, "target found, % (of n)",
      [](const ColorRow& row, size_t method) {
        return Fixed(100.0 * row.found[method].value_1(), 1) + " (" +
               std::to_string(row.found[method].n) + ")";
      },
      &out);
  out << "\n";
  PrintTable(
      record, "median overlap (IoU) with the true mask",
      [](const ColorRow& row, size_t method) { return Fixed(row.median_iou_1[method], 3); }, &out);
  return out.str();
}

}  // namespace geon::cli
