#pragma once

#include "active_vision/fuse_views.h"
#include "active_vision/view_gain.h"

namespace geon::active_vision {

// What was learned about looking again: how to weigh several views of a target together, and what
// another one will tell.
struct ViewTable {
  FusionOptions fusion;
  ViewGainTable gain{};
};

// Source: ours; the table that `geon train views` made, compiled in (view_gain_table.inc).
const ViewTable& TrainedViewTable();

}  // namespace geon::active_vision
