#include "procs/geon/experiment_bench.h"

#include <mutex>

#include "base/angles.h"
#include "evaluation/thesis_objects.h"
#include "evaluation/trial_random.h"
#include "procs/geon/experiment_objects.h"
#include "procs/geon/parallel_for.h"
#include "procs/geon/picture_uri.h"

namespace geon::cli {
namespace {

struct BenchCase {
  int t;
  const BenchObject* object;
  double range_m;
  int pose;
  const BenchObject::Position& shown() const {
    return object->positions[static_cast<size_t>(pose) % object->positions.size()];
  }
};

std::vector<BenchCase> Cases(const std::vector<BenchObject>& objects, const BenchPlan& plan,
                             Shard shard) {
  std::vector<BenchCase> cases;
  int t = 0;
  for (const double range_m : plan.ranges_m) {
    for (const BenchObject& object : objects) {
      for (int pose = 0; pose < plan.poses; ++pose, ++t) {
        if (t % shard.count == shard.index - 1) cases.push_back({t, &object, range_m, pose});
      }
    }
  }
  return cases;
}

std::optional<double> Since(const std::optional<double>& begin_s, double end_s) {
  if (!begin_s) return std::nullopt;
  return end_s - *begin_s;
}

lockstep::BenchTrial TrialOf(const BenchCase& each, const BenchPlan& plan) {
  std::mt19937_64 random = evaluation::TrialRandom(plan.seed, static_cast<uint64_t>(each.t));
  lockstep::BenchTrial trial;
  trial.shape = each.shown().second;
  trial.range_m = each.range_m;
  trial.yaw_rad = 2.0 * kPi * (each.pose + evaluation::Uniform(random, 0.0, 1.0)) / plan.poses;
  trial.seed = random();
  return trial;
}

BenchTrialRecord RecordOf(const BenchCase& each, const lockstep::BenchTrial& bench,
                          const lockstep::BenchOutcome& outcome) {
  BenchTrialRecord trial;
  trial.t = each.t;
  trial.subject = {each.object->truth, each.object->name, each.shown().first};
  trial.range_m = each.range_m;
  trial.yaw_deg = DegreesFromRadians(bench.yaw_rad);
  trial.end = outcome.end;
  trial.from_sight_s = Since(outcome.seen_s, outcome.end_s);
  trial.from_view_s = Since(outcome.whole_s, outcome.end_s);
  trial.misplaced_1 = outcome.misplaced_1;
  if (outcome.verdict) {
    trial.answer = outcome.verdict->label;
    trial.confidence = outcome.verdict->confidence;
    trial.decided = outcome.verdict->decided;
  }
  return trial;
}

// Without stripes and picture, which only the worst are worth.
WorstView ViewOf(const BenchTrialRecord& trial, const lockstep::BenchOutcome& outcome) {
  WorstView view;
  view.t = trial.t;
  view.right = trial.right();
  view.confidence_1 = trial.confidence;
  if (outcome.verdict) {
    view.posterior = outcome.verdict->posterior;
    view.reasons = outcome.verdict->reasons;
  }
  return view;
}

}  // namespace

std::vector<BenchObject> ThesisBenchObjects() {
  std::vector<BenchObject> objects;
  for (const evaluation::ExperimentObject& object : evaluation::ThesisObjects()) {
    BenchObject shown{object.shape.label, object.name, {}};
    for (const int position : object.positions) {
      geons::GeonShape shape = object.shape;
      shape.position = position;
      shown.positions.emplace_back(position, shape);
    }
    objects.push_back(std::move(shown));
  }
  return objects;
}

Result<std::vector<BenchObject>> LoadBenchMeshes(const std::filesystem::path& directory,
                                                 double largest_m) {
  const Result<std::vector<ShownObject>> meshes = LoadShownMeshes(directory, largest_m);
  if (!meshes.ok()) return meshes.status();
  std::vector<BenchObject> objects;
  for (const ShownObject& mesh : *meshes) {
    const evaluation::Subject& subject = mesh.subject;
    const sim::MeshShape shape{directory / (subject.object + ".obj"),
                               geons::Bounds(mesh.mesh).sizes().z(), subject.truth};
    objects.push_back({subject.truth, subject.object, {{subject.position, shape}}});
  }
  return objects;
}

Result<BenchRun> RunBench(const lockstep::LockstepSettings& settings,
                          const std::optional<recognizer::StripeCalibration>& calibration,
                          const std::vector<BenchObject>& objects, const BenchPlan& plan,
                          Shard shard, int jobs, const std::function<void(double)>& progress) {
  const std::vector<BenchCase> cases = Cases(objects, plan, shard);
  BenchRun run;
  run.trials.resize(cases.size());
  Status failed = Status::Ok();
  std::mutex mutex;  // over all of these
  size_t done = 0;
  ParallelFor(jobs, static_cast<int>(cases.size()), [&](int k) {
    const BenchCase& each = cases[static_cast<size_t>(k)];
    const lockstep::BenchTrial bench = TrialOf(each, plan);
    const Result<lockstep::BenchOutcome> outcome =
        lockstep::RunBenchTrial(settings, calibration, bench);
    const std::lock_guard lock(mutex);
    progress(static_cast<double>(++done) / static_cast<double>(cases.size()));
    if (!outcome.ok()) {
      failed = outcome.status();
      return;
    }
    BenchTrialRecord& trial = run.trials[static_cast<size_t>(k)];
    trial = RecordOf(each, bench, *outcome);
    WorstView view = ViewOf(trial, *outcome);
    if (!IsAmongWorst(view, run.worst)) return;
    view.stripes = DrawStripes(outcome->scan);
    view.picture_uri = PictureUri(outcome->view, outcome->mask);
    AddWorstView(std::move(view), &run.worst);
  });
  if (!failed.ok()) return failed;
  return run;
}

}  // namespace geon::cli
