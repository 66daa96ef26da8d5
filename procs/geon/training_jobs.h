#pragma once

#include <mutex>
#include <string>
#include <utility>

#include "evaluation/train_forest.h"
#include "procs/geon/parallel_for.h"
#include "procs/geon/progress.h"

namespace geon::cli {

// Does the tasks of a training, `jobs` at a time, and says on stderr how far it is.
class TrainingJobs {
 public:
  TrainingJobs(std::string command, int jobs) : jobs_(jobs), progress_(std::move(command)) {}

  // For as long as this lives.
  evaluation::ForEach ForEach() {
    return [this](double share_1, int count, const std::function<void(int)>& task) {
      ParallelFor(jobs_, count, [&](int k) {
        task(k);
        const std::lock_guard lock(mutex_);
        done_1_ += share_1 / count;
        progress_.Say(done_1_);
      });
    };
  }

 private:
  int jobs_;
  std::mutex mutex_;  // of what follows
  Progress progress_;
  double done_1_ = 0.0;
};

}  // namespace geon::cli
