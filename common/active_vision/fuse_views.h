#pragma once

#include <span>

#include "sensor/geon_verdict.h"

namespace geon::active_vision {

struct FusionOptions {
  double weight_1 = 1.0;    // of every view's log posterior; below 1 where views tell the same
  double decided_1 = 0.97;  // from this fused posterior on the answer counts as decided
};

// As `geon train views` found them (view_table.h).
FusionOptions TrainedFusion();

// What several looks at one target say together: the newest verdict, with the label, posterior and
// confidence of all. Posteriors multiply, each to the power of the weight (the prior over the seven
// shapes is flat); no view rules a shape out for good. Decided when the fused posterior says so, or
// when the only view was.
//
// Source: Genest and Zidek 1986, "Combining probability distributions" (the logarithmic pool);
// Arbel and Ferrie, "Viewpoint selection by navigation through entropy maps", ICCV 1999, for
// recognition from several views.
// `verdicts` must not be empty (ContractViolation).
sensor::GeonVerdict FuseViews(std::span<const sensor::GeonVerdict> verdicts,
                              const FusionOptions& options = TrainedFusion());

}  // namespace geon::active_vision
