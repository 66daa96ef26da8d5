#pragma once

#include <array>
#include <span>

#include "base/geon_label.h"
#include "sensor/geon_verdict.h"

namespace geon::active_vision {

struct FusionOptions {
  double weight_1 = 1.0;    // of every view's log posterior; below 1 where views tell the same
  double decided_1 = 0.97;  // from this fused posterior on the answer counts as decided
};

// What several looks at one target say together: the newest verdict, with the label, posterior and
// confidence of all. Views count as independent: their posteriors multiply (the prior over the
// seven shapes is flat). Decided when the fused posterior says so, or when the only view was.
//
// Source: Roberts, Arbel and Ferrie on sequential recognition from several views (see Arbel and
// Ferrie, "Viewpoint selection by navigation through entropy maps", ICCV 1999).
// `verdicts` must not be empty.
sensor::GeonVerdict FuseViews(std::span<const sensor::GeonVerdict> verdicts,
                              const FusionOptions& options = {});

}  // namespace geon::active_vision
