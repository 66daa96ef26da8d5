#include "procs/geon/bench_record.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "procs/geon/experiment_json.h"
#include "procs/geon/experiment_rates.h"
#include "procs/geon/join_shards.h"

namespace geon::cli {
namespace {

using nlohmann::json;

json BenchTrialJson(const BenchTrialRecord& trial) {
  return {{"t", trial.t},
          {"truth", ToString(trial.subject.truth)},
          {"object", trial.subject.object},
          {"position", trial.subject.position},
          {"range_m", trial.range_m},
          {"yaw_deg", trial.yaw_deg},
          {"answer", LabelJson(trial.answer)},
          {"confidence", trial.confidence},
          {"decided", trial.decided},
          {"end", trial.end},
          {"from_sight_s", OptionalJson(trial.from_sight_s)},
          {"from_view_s", OptionalJson(trial.from_view_s)},
          {"misplaced", trial.misplaced_1}};
}

BenchTrialRecord ParseBenchTrial(const json& value) {
  BenchTrialRecord trial;
  trial.t = value.at("t");
  trial.subject = {ParseLabel(value.at("truth")), value.at("object"), value.at("position")};
  trial.range_m = value.at("range_m");
  trial.yaw_deg = value.at("yaw_deg");
  trial.answer = ParseOptionalLabel(value.at("answer"));
  trial.confidence = value.at("confidence");
  trial.decided = value.at("decided");
  trial.end = value.at("end");
  trial.from_sight_s = ParseOptional(value.at("from_sight_s"));
  trial.from_view_s = ParseOptional(value.at("from_view_s"));
  trial.misplaced_1 = value.at("misplaced").get<std::vector<double>>();
  return trial;
}

json BenchCells(const BenchRecord& record) {
  std::vector<Answer> answers;
  for (const BenchTrialRecord& trial : record.trials) {
    answers.push_back({trial.subject, trial.range_m, trial.answer, trial.decided});
  }
  return AnswerCells(answers);
}

std::vector<double> TimesOf(const BenchRecord& record,
                            std::optional<double> BenchTrialRecord::*time_s) {
  std::vector<double> times_s;
  for (const BenchTrialRecord& trial : record.trials) {
    if (trial.answer && trial.*time_s) times_s.push_back(*(trial.*time_s));
  }
  return times_s;
}

json BenchRates(const BenchRecord& record) {
  json ranges = json::array();
  evaluation::SuccessRate all;
  for (const BenchRange& range : BenchRanges(record)) {
    ranges.push_back(RateJson(range.all));
    ranges.back()["range_m"] = range.range_m;
    const auto classes = evaluation::RatesByClass(range.rows);
    for (size_t r = 0; r < range.rows.size(); ++r) {
      const auto truth = static_cast<size_t>(range.rows[r].subject.truth);
      evaluation::SuccessRate rate = classes[truth];
      rate.n += range.unanswered[r];
      ranges.back()["classes"][std::string(kGeonLabelNames[truth])] = RateJson(rate);
    }
    all.right += range.all.right;
    all.n += range.all.n;
  }
  return {{"all", RateJson(all)},
          {"ranges", ranges},
          {"from_sight_s", SpreadJson(SightTimes(record))},
          {"from_view_s", SpreadJson(ViewTimes(record))},
          {"misplaced", SpreadJson(Misplacements(record))}};
}

}  // namespace

std::vector<double> SightTimes(const BenchRecord& record) {
  return TimesOf(record, &BenchTrialRecord::from_sight_s);
}
std::vector<double> ViewTimes(const BenchRecord& record) {
  return TimesOf(record, &BenchTrialRecord::from_view_s);
}

std::vector<double> Misplacements(const BenchRecord& record) {
  std::vector<double> all_1;
  for (const BenchTrialRecord& trial : record.trials) {
    for (const double misplaced_1 : trial.misplaced_1) all_1.push_back(std::abs(misplaced_1));
  }
  return all_1;
}

std::vector<BenchRange> BenchRanges(const BenchRecord& record) {
  std::vector<BenchRange> ranges;
  for (const BenchTrialRecord& trial : record.trials) {
    const auto at_range = [&](const BenchRange& each) { return each.range_m == trial.range_m; };
    auto range = std::find_if(ranges.begin(), ranges.end(), at_range);
    if (range == ranges.end()) {
      range = ranges.insert(ranges.end(), BenchRange());
      range->range_m = trial.range_m;
    }
    const auto of_truth = [&](const evaluation::ConfusionRow& each) {
      return each.subject.truth == trial.subject.truth;
    };
    auto row = std::find_if(range->rows.begin(), range->rows.end(), of_truth);
    if (row == range->rows.end()) {
      row = range->rows.insert(row, evaluation::ConfusionRow());
      row->subject = {trial.subject.truth, "", 0};
      range->unanswered.push_back(0);
    }
    range->all.Count(trial.right());
    if (!trial.answer) {
      ++range->unanswered[static_cast<size_t>(row - range->rows.begin())];
      continue;
    }
    ++row->counts[static_cast<size_t>(*trial.answer)];
    if (!trial.decided) ++row->undecided;
  }
  return ranges;
}

std::string BenchRecordText(const BenchRecord& record) {
  json trials = json::array(), worst = json::array();
  for (const BenchTrialRecord& trial : record.trials) trials.push_back(BenchTrialJson(trial));
  for (const WorstView& view : record.worst) worst.push_back(ToJson(view));
  return json{{"format", kExperimentFormat},
              {"experiment", kBenchExperiment},
              {"method", record.method},
              {"seed", record.seed},
              {"git", record.git},
              {"conditions", record.conditions},
              {"cells", BenchCells(record)},
              {"trials", trials},
              {"worst", worst},
              {"rates", BenchRates(record)},
              {"seconds", nullptr}}
             .dump() +
         "\n";
}

Result<BenchRecord> ParseBenchRecord(const json& value, const std::string& name) {
  try {
    if (value.at("format") != kExperimentFormat || value.at("experiment") != kBenchExperiment) {
      return Status::Error(name + ": not the results of geon experiment bench");
    }
    BenchRecord record;
    record.method = value.at("method");
    record.seed = value.at("seed");
    record.git = value.at("git");
    record.conditions = value.at("conditions");
    for (const json& trial : value.at("trials")) record.trials.push_back(ParseBenchTrial(trial));
    for (const json& each : value.at("worst")) {
      WorstView view = ParseWorstView(each);
      const auto trial = std::find_if(
          record.trials.begin(), record.trials.end(),
          [&view](const BenchTrialRecord& candidate) { return candidate.t == view.t; });
      if (trial == record.trials.end()) {
        throw std::runtime_error("a view of trial " + std::to_string(view.t) +
                                 ", which is not there");
      }
      view.right = trial->right();
      view.confidence_1 = trial->confidence;
      AddWorstView(std::move(view), &record.worst);
    }
    return record;
  } catch (const std::exception& error) {
    return Status::Error(name + ": damaged results: " + error.what());
  }
}

Result<BenchRecord> MergeBenchRecords(const std::vector<BenchRecord>& shards) {
  return JoinShards(
      shards, &BenchRecord::trials,
      [](const BenchRecord& a, const BenchRecord& b) {
        return a.method == b.method && a.seed == b.seed && a.git == b.git &&
               a.conditions == b.conditions;
      },
      [](const BenchRecord& shard, BenchRecord* all) {
        for (const WorstView& view : shard.worst) AddWorstView(view, &all->worst);
      });
}

}  // namespace geon::cli
