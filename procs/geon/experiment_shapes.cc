#include "procs/geon/experiment_shapes.h"

#include <algorithm>

#include "procs/geon/parallel_for.h"

namespace geon::cli {
namespace {

void KeepIfWorst(const evaluation::ShapeTrial& trial, GeonLabel truth, const sensor::ScanSet& scan,
                 const sensor::GeonVerdict& verdict, std::vector<WorstView>* worst) {
  WorstView view{trial.t, trial.answer == truth, trial.confidence, verdict.posterior, {}, {}, {}};
  if (!IsAmongWorst(view, *worst)) return;
  view.reasons = verdict.reasons;
  view.stripes = DrawStripes(scan);
  AddWorstView(std::move(view), worst);
}

ShapeRun RunObject(const ShownObject& object, int subject,
                   const std::vector<evaluation::ViewingCell>& sphere,
                   const evaluation::SphereConditions& conditions, const Recognizer& recognize,
                   Shard shard) {
  const evaluation::ObjectTracer tracer(object.mesh);
  ShapeRun run;
  for (size_t c = 0; c < sphere.size(); ++c) {
    const int t = subject * static_cast<int>(sphere.size()) + static_cast<int>(c);
    if (t % shard.count != shard.index - 1) continue;
    const sensor::ScanSet scan = evaluation::MakeTrialScan(tracer, sphere[c], t, conditions);
    const sensor::GeonVerdict verdict = recognize(scan);
    run.trials.push_back(
        {t, subject, sphere[c], verdict.label, verdict.confidence, verdict.decided});
    KeepIfWorst(run.trials.back(), object.subject.truth, scan, verdict, &run.worst);
  }
  return run;
}

}  // namespace

ShapeRun RunShapeTrials(const std::vector<ShownObject>& objects,
                        const std::vector<evaluation::ViewingCell>& sphere,
                        const evaluation::SphereConditions& conditions, const Recognizer& recognize,
                        Shard shard, int jobs) {
  std::vector<ShapeRun> by_object(objects.size());
  ParallelFor(jobs, static_cast<int>(objects.size()), [&](int k) {
    const auto at = static_cast<size_t>(k);
    by_object[at] = RunObject(objects[at], k, sphere, conditions, recognize, shard);
  });
  ShapeRun run;
  for (ShapeRun& own : by_object) {
    run.trials.insert(run.trials.end(), own.trials.begin(), own.trials.end());
    for (WorstView& view : own.worst) AddWorstView(std::move(view), &run.worst);
  }
  return run;
}

}  // namespace geon::cli
