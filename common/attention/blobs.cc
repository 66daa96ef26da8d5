#include "attention/blobs.h"

#include <algorithm>
#include <cstdint>

namespace geon::attention {
namespace {

struct Extent {
  int left = INT32_MAX, right = 0, top = INT32_MAX, bottom = 0;
  int64_t pixels = 0, u_sum = 0, v_sum = 0;
};

// Sum of the columns of a run.
int64_t ColumnSum(const PixelRun& run) {
  return int64_t{run.u_begin_px + run.u_end_px - 1} * (run.u_end_px - run.u_begin_px) / 2;
}

}  // namespace

std::vector<Blob> MeasureBlobs(const PixelGroups& groups) {
  std::vector<Extent> extents(static_cast<size_t>(groups.count));
  for (const PixelRun& run : groups.runs) {
    Extent& extent = extents[static_cast<size_t>(run.group)];
    const int length = run.u_end_px - run.u_begin_px;
    extent.left = std::min(extent.left, run.u_begin_px);
    extent.right = std::max(extent.right, run.u_end_px);
    extent.top = std::min(extent.top, run.v_px);
    extent.bottom = run.v_px + 1;
    extent.pixels += length;
    extent.u_sum += ColumnSum(run);
    extent.v_sum += int64_t{run.v_px} * length;
  }
  std::vector<Blob> blobs;
  blobs.reserve(extents.size());
  for (const Extent& extent : extents) {
    const auto pixels = static_cast<double>(extent.pixels);
    blobs.push_back(
        {{extent.left, extent.top, extent.right - extent.left, extent.bottom - extent.top},
         static_cast<int>(extent.pixels),
         {static_cast<double>(extent.u_sum) / pixels, static_cast<double>(extent.v_sum) / pixels}});
  }
  return blobs;
}

Eigen::Vector2d BottomPoint(const PixelGroups& groups, int group) {
  int v = -1;
  int64_t u_sum = 0;
  int64_t pixels = 0;
  for (const PixelRun& run : groups.runs) {
    if (run.group != group) continue;
    if (run.v_px != v) u_sum = pixels = 0;
    v = run.v_px;
    u_sum += ColumnSum(run);
    pixels += run.u_end_px - run.u_begin_px;
  }
  return {static_cast<double>(u_sum) / static_cast<double>(pixels), static_cast<double>(v)};
}

}  // namespace geon::attention
