#include "procs/geon/experiment_shapes.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace geon::cli {
namespace {

using evaluation::ShapeTrial;

std::vector<ShapeTrial> RunObject(const ShownObject& object, int subject,
                                  const std::vector<evaluation::ViewingCell>& sphere,
                                  const evaluation::SphereConditions& conditions,
                                  const Recognizer& recognize, Shard shard) {
  const evaluation::ObjectTracer tracer(object.mesh);
  std::vector<ShapeTrial> trials;
  for (size_t c = 0; c < sphere.size(); ++c) {
    const int t = subject * static_cast<int>(sphere.size()) + static_cast<int>(c);
    if (t % shard.count != shard.index - 1) continue;
    const sensor::ScanSet scan = evaluation::MakeTrialScan(tracer, sphere[c], t, conditions);
    const sensor::GeonVerdict verdict = recognize(scan);
    trials.push_back({t, subject, sphere[c], verdict.label, verdict.confidence, verdict.decided});
  }
  return trials;
}

}  // namespace

std::vector<ShapeTrial> RunShapeTrials(const std::vector<ShownObject>& objects,
                                       const std::vector<evaluation::ViewingCell>& sphere,
                                       const evaluation::SphereConditions& conditions,
                                       const Recognizer& recognize, Shard shard, int jobs) {
  std::vector<std::vector<ShapeTrial>> by_object(objects.size());
  std::atomic<size_t> next{0};
  const auto work = [&] {
    for (size_t k = next++; k < objects.size(); k = next++) {
      by_object[k] =
          RunObject(objects[k], static_cast<int>(k), sphere, conditions, recognize, shard);
    }
  };
  {
    std::vector<std::jthread> workers;
    for (int job = 1; job < jobs; ++job) workers.emplace_back(work);
    work();
  }
  std::vector<ShapeTrial> trials;
  for (const auto& own : by_object) trials.insert(trials.end(), own.begin(), own.end());
  return trials;
}

}  // namespace geon::cli
