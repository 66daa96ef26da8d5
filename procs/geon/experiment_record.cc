#include "procs/geon/experiment_record.h"

#include <algorithm>
#include <stdexcept>

#include "base/angles.h"
#include "evaluation/shape_tables.h"
#include "procs/geon/experiment_json.h"
#include "procs/geon/experiment_rates.h"
#include "procs/geon/join_shards.h"

namespace geon::cli {
namespace {

using evaluation::ConfusionRow;
using evaluation::ShapeTrial;
using evaluation::Subject;
using nlohmann::json;

json TrialJson(const ShapeTrial& trial, const Subject& subject) {
  return {{"t", trial.t},
          {"subject", trial.subject},
          {"truth", ToString(subject.truth)},
          {"object", subject.object},
          {"position", subject.position},
          {"elevation_deg", WholeDegrees(trial.cell.elevation_rad)},
          {"azimuth_deg", WholeDegrees(trial.cell.azimuth_rad)},
          {"answer", ToString(trial.answer)},
          {"confidence", trial.confidence},
          {"decided", trial.decided}};
}

ShapeTrial ParseTrial(const json& value) {
  ShapeTrial trial;
  trial.t = value.at("t");
  trial.subject = value.at("subject");
  trial.cell.elevation_rad = RadiansFromDegrees(value.at("elevation_deg").get<int>());
  trial.cell.azimuth_rad = RadiansFromDegrees(value.at("azimuth_deg").get<int>());
  trial.answer = ParseLabel(value.at("answer"));
  trial.confidence = value.at("confidence");
  trial.decided = value.at("decided");
  if (!(trial.confidence >= 0.0 && trial.confidence <= 1.0)) {
    throw std::runtime_error("trial " + std::to_string(trial.t) +
                             ": a confidence lies within 0 and 1");
  }
  return trial;
}

// Records made before views were kept have none. `trials` are by rising t.
std::vector<WorstView> ParseWorst(const json& record, const std::vector<Subject>& subjects,
                                  const std::vector<ShapeTrial>& trials) {
  std::vector<WorstView> worst;
  for (const json& value : record.value("worst", json::array())) {
    WorstView view = ParseWorstView(value);
    const auto trial = std::lower_bound(trials.begin(), trials.end(), view.t,
                                        [](const ShapeTrial& each, int t) { return each.t < t; });
    if (trial == trials.end() || trial->t != view.t) {
      throw std::runtime_error("a view of trial " + std::to_string(view.t) +
                               ", which is not there");
    }
    view.right = trial->answer == subjects[static_cast<size_t>(trial->subject)].truth;
    view.confidence_1 = trial->confidence;
    AddWorstView(std::move(view), &worst);
  }
  return worst;
}

}  // namespace

std::string RecordText(const ShapeRecord& record) {
  json cells = json::array(), trials = json::array(), subjects = json::array();
  json worst = json::array();
  for (const WorstView& view : record.worst) worst.push_back(ToJson(view));
  const json& range_m = record.conditions.at("range_m");
  for (const ConfusionRow& row : evaluation::CountAnswers(record.subjects, record.trials)) {
    cells.push_back(CellJson(row, row.n(), range_m));
  }
  for (const Subject& subject : record.subjects) {
    subjects.push_back({{"truth", ToString(subject.truth)},
                        {"object", subject.object},
                        {"position", subject.position}});
  }
  for (const ShapeTrial& trial : record.trials) {
    trials.push_back(TrialJson(trial, record.subjects[static_cast<size_t>(trial.subject)]));
  }
  return json{{"format", kExperimentFormat},
              {"experiment", "shapes"},
              {"method", record.method},
              {"seed", record.seed},
              {"git", record.git},
              {"conditions", record.conditions},
              {"subjects", subjects},
              {"cells", cells},
              {"trials", trials},
              {"worst", worst},
              {"rates", RatesJson(record.subjects, record.trials)},
              {"seconds", nullptr}}
             .dump() +
         "\n";
}

Result<ShapeRecord> ParseRecord(const json& value, const std::string& name) {
  try {
    if (value.at("format") != kExperimentFormat || value.at("experiment") != "shapes") {
      return Status::Error(name + ": not the results of geon experiment shapes");
    }
    ShapeRecord record;
    record.method = value.at("method");
    record.seed = value.at("seed");
    record.git = value.at("git");
    record.conditions = value.at("conditions");
    for (const json& subject : value.at("subjects")) {
      record.subjects.push_back(
          {ParseLabel(subject.at("truth")), subject.at("object"), subject.at("position")});
    }
    for (const json& trial : value.at("trials")) {
      record.trials.push_back(ParseTrial(trial));
      if (record.trials.back().subject < 0 ||
          static_cast<size_t>(record.trials.back().subject) >= record.subjects.size()) {
        return Status::Error(name + ": a trial of a subject that is not there");
      }
    }
    record.worst = ParseWorst(value, record.subjects, record.trials);
    return record;
  } catch (const std::exception& error) {
    return Status::Error(name + ": damaged results: " + error.what());
  }
}

Result<ShapeRecord> MergeRecords(const std::vector<ShapeRecord>& shards) {
  return JoinShards(
      shards, &ShapeRecord::trials,
      [](const ShapeRecord& a, const ShapeRecord& b) {
        return a.method == b.method && a.seed == b.seed && a.git == b.git &&
               a.conditions == b.conditions && a.subjects.size() == b.subjects.size();
      },
      [](const ShapeRecord& shard, ShapeRecord* all) {
        for (const WorstView& view : shard.worst) AddWorstView(view, &all->worst);
      });
}

std::string RecordTables(const ShapeRecord& record) {
  return evaluation::ShapeTables(
      evaluation::CountAnswers(record.subjects, record.trials),
      evaluation::RatesByCell(record.subjects, record.trials),
      evaluation::MeasureReliability(evaluation::PredictionsOf(record.subjects, record.trials)));
}

}  // namespace geon::cli
