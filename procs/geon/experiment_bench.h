#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "procs/geon/bench_record.h"
#include "procs/geon/experiment_shapes.h"
#include "procs/lockstep/bench_trial.h"

namespace geon::cli {

// An object as the bench can show it: in one of its stable positions.
struct BenchObject {
  GeonLabel truth;
  std::string name;
  // What to show, and how its position is called; one of each.
  using Position = std::pair<int, decltype(lockstep::BenchTrial::shape)>;
  std::vector<Position> positions;
};

// The 28 objects of thesis section 6.1.
std::vector<BenchObject> ThesisBenchObjects();
// The meshes that DIR/labels.csv names, as they lie in their files, their largest side
// `largest_m`.
Result<std::vector<BenchObject>> LoadBenchMeshes(const std::filesystem::path& directory,
                                                 double largest_m);

struct BenchPlan {
  std::vector<double> ranges_m = {1.0, 1.3, 1.6};
  int poses = 12;  // of each object at each range: stable positions in turn, yaws all round
  uint64_t seed = 1;
};

struct BenchRun {
  std::vector<BenchTrialRecord> trials;  // by rising t
  std::vector<WorstView> worst;
};

// Runs every trial of a shard, `jobs` at a time; `progress` is told the share that is done, from
// any thread. Errors: a mesh that cannot be used.
Result<BenchRun> RunBench(const lockstep::LockstepSettings& settings,
                          const std::optional<recognizer::StripeCalibration>& calibration,
                          const std::vector<BenchObject>& objects, const BenchPlan& plan,
                          Shard shard, int jobs, const std::function<void(double)>& progress);

}  // namespace geon::cli
