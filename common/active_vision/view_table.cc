#include "active_vision/view_table.h"

namespace geon::active_vision {
namespace {

#include "active_vision/view_gain_table.inc"

}  // namespace

const ViewTable& TrainedViewTable() { return kViewTable; }

}  // namespace geon::active_vision
