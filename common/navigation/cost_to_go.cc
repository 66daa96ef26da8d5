#include "navigation/cost_to_go.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "base/contracts.h"

namespace geon::navigation {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();
constexpr std::array<GridCell, 8> kNeighbours = {GridCell{1, 0}, {1, 1},   {0, 1},  {-1, 1},
                                                 {-1, 0},        {-1, -1}, {0, -1}, {1, -1}};

constexpr uint8_t kNoNeighbour = kNeighbours.size();
constexpr float kTight_1 = 20.0F;  // what a metre too near to an obstacle costs, on the way out

}  // namespace

std::optional<std::string> CostToGoOptions::Validate() const {
  if (!(least_clearance_m > 0.0 && easy_clearance_m > least_clearance_m)) {
    return "least_clearance_m must be positive and below easy_clearance_m";
  }
  if (!(crowding_1 >= 0.0 && unseen_1 >= 0.0)) return "crowding_1, unseen_1 must not be negative";
  return std::nullopt;
}

CostToGo::CostToGo(const CostToGoOptions& options) : options_(options) {
  const std::optional<std::string> error = options.Validate();
  Require(!error, "CostToGoOptions: " + error.value_or(""));
}

double CostToGo::At(GridCell cell) const {
  return !cells_.empty() && window_.Contains(cell) ? double{cells_[framed_.Index(cell)].cost_m}
                                                   : double{kNever};
}

std::optional<GridCell> CostToGo::Next(GridCell cell) const {
  if (cells_.empty() || !window_.Contains(cell)) return std::nullopt;
  const uint8_t next = cells_[framed_.Index(cell)].next;
  if (next == kNoNeighbour) return std::nullopt;
  return GridCell{cell.x + kNeighbours[next].x, cell.y + kNeighbours[next].y};
}

void CostToGo::Weigh(const OccupancyGrid& grid, const ClearanceField& clearance) {
  window_ = clearance.window();
  framed_ = {{window_.first.x - 1, window_.first.y - 1}, {window_.last.x + 1, window_.last.y + 1}};
  cells_.assign(framed_.size(), {kNever, kNever, kNoNeighbour, false});
  const auto cell_m = static_cast<float>(grid.cell_m());
  const auto least_m = static_cast<float>(options_.least_clearance_m);
  const auto easy_m = static_cast<float>(options_.easy_clearance_m);
  // No step passes between two obstacles that are less than twice this apart.
  const float blocked_m = std::min(1.5F * cell_m, least_m);
  for (int y = window_.first.y; y <= window_.last.y; ++y) {
    for (int x = window_.first.x; x <= window_.last.x; ++x) {
      const float clearance_m = clearance.At({x, y});
      if (clearance_m < blocked_m) continue;
      Cell& cell = cells_[framed_.Index({x, y})];
      cell.tight = clearance_m < least_m;
      cell.per_metre_1 = cell.tight ? kTight_1 : 1.0F;
      if (!cell.tight && clearance_m < easy_m) {
        const float crowded_1 = (easy_m - clearance_m) / (easy_m - least_m);
        cell.per_metre_1 += static_cast<float>(options_.crowding_1) * crowded_1 * crowded_1;
      }
      if (!grid.IsSeen({x, y})) cell.per_metre_1 += static_cast<float>(options_.unseen_1);
    }
  }
}

void CostToGo::Compute(const OccupancyGrid& grid, const ClearanceField& clearance,
                       std::span<const Goal> goals) {
  Weigh(grid, clearance);
  const auto cell_m = static_cast<float>(grid.cell_m());
  std::array<float, kNeighbours.size()> step_m;
  std::array<ptrdiff_t, kNeighbours.size()> step;  // from cell to cell in cells_
  for (size_t n = 0; n < kNeighbours.size(); ++n) {
    step_m[n] = n % 2 == 0 ? cell_m : 1.41421356F * cell_m;
    step[n] = kNeighbours[n].y * ptrdiff_t{framed_.width()} + kNeighbours[n].x;
  }
  // Costs differ by at most a diagonal step through the worst cell: as many buckets in a ring.
  const float bucket_m = 0.5F * cell_m;
  const float most_1 = std::max(kTight_1, 1.0F + static_cast<float>(options_.crowding_1)) +
                       static_cast<float>(options_.unseen_1);
  const auto ring = std::bit_ceil(static_cast<uint32_t>(1.5F * cell_m * most_1 / bucket_m) + 3);
  buckets_.resize(ring);
  for (std::vector<uint32_t>& bucket : buckets_) bucket.clear();
  size_t waiting = 0;
  // In ascending order of cost: the first bucket is the cheapest goal's.
  std::vector<Goal> sorted(goals.begin(), goals.end());
  std::erase_if(sorted, [&](const Goal& goal) {
    return !window_.Contains(goal.cell) ||
           clearance.At(goal.cell) < static_cast<float>(options_.least_clearance_m);
  });
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Goal& a, const Goal& b) { return a.cost_m < b.cost_m; });
  size_t next_goal = 0;
  const auto bucket_of = [&](float cost_m) { return static_cast<int>(cost_m / bucket_m); };
  const auto bucket_at = [&](int number) -> std::vector<uint32_t>& {
    return buckets_[static_cast<uint32_t>(number) & (ring - 1)];
  };
  const auto reach = [&](size_t index, float cost_m, size_t next) {
    cells_[index].cost_m = cost_m;
    cells_[index].next = static_cast<uint8_t>(next);
    bucket_at(bucket_of(cost_m)).push_back(static_cast<uint32_t>(index));
    ++waiting;
  };
  for (int now = sorted.empty() ? 0 : bucket_of(static_cast<float>(sorted[0].cost_m));
       waiting > 0 || next_goal < sorted.size(); ++now) {
    for (; next_goal < sorted.size(); ++next_goal) {
      const auto cost_m = static_cast<float>(sorted[next_goal].cost_m);
      if (bucket_of(cost_m) > now) break;
      const size_t index = framed_.Index(sorted[next_goal].cell);
      if (cost_m < cells_[index].cost_m) reach(index, cost_m, kNoNeighbour);
    }
    std::vector<uint32_t>& bucket = bucket_at(now);
    for (size_t k = 0; k < bucket.size(); ++k) {  // may grow meanwhile
      const size_t index = bucket[k];
      --waiting;
      const Cell& cell = cells_[index];
      const float cost_m = cell.cost_m;
      if (bucket_of(cost_m) != now) continue;  // was reached more cheaply before
      for (size_t n = 0; n < kNeighbours.size(); ++n) {
        const size_t from_index = index + static_cast<size_t>(step[n]);
        const Cell& from = cells_[from_index];
        const float from_cost_m = cost_m + step_m[n] * from.per_metre_1;
        if (from_cost_m >= from.cost_m) continue;
        if (cell.tight && !from.tight) continue;  // out, never through
        reach(from_index, from_cost_m, (n + 4) % kNeighbours.size());
      }
    }
    bucket.clear();
  }
}

}  // namespace geon::navigation
