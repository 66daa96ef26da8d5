#include "navigation/cost_to_go.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/contracts.h"

namespace geon::navigation {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();
constexpr std::array<GridCell, 8> kNeighbours = {GridCell{1, 0}, {1, 1},   {0, 1},  {-1, 1},
                                                 {-1, 0},        {-1, -1}, {0, -1}, {1, -1}};

constexpr uint8_t kNoNeighbour = kNeighbours.size();

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
  return !cost_m_.empty() && window_.Contains(cell) ? double{cost_m_[window_.Index(cell)]}
                                                    : double{kNever};
}

std::optional<GridCell> CostToGo::Next(GridCell cell) const {
  if (cost_m_.empty() || !window_.Contains(cell) || next_[window_.Index(cell)] == kNoNeighbour)
    return std::nullopt;
  const GridCell& step = kNeighbours[next_[window_.Index(cell)]];
  return GridCell{cell.x + step.x, cell.y + step.y};
}

void CostToGo::Compute(const OccupancyGrid& grid, const ClearanceField& clearance,
                       std::span<const Goal> goals) {
  window_ = clearance.window();
  cost_m_.assign(window_.size(), kNever);
  next_.assign(window_.size(), kNoNeighbour);
  const auto cell_m = static_cast<float>(grid.cell_m());
  const auto least_m = static_cast<float>(options_.least_clearance_m);
  const auto easy_m = static_cast<float>(options_.easy_clearance_m);
  // No step passes between two obstacles that are less than twice this apart.
  const float blocked_m = std::min(1.5F * cell_m, least_m);

  // Costs differ by at most a diagonal step through the worst cell: as many buckets in a ring.
  const float bucket_m = 0.5F * cell_m;
  constexpr float kTight_1 = 20.0F;  // what a metre too near to an obstacle costs, on the way out
  const float most_1 = std::max(kTight_1, 1.0F + static_cast<float>(options_.crowding_1)) +
                       static_cast<float>(options_.unseen_1);
  const auto ring = static_cast<size_t>(std::ceil(1.5F * cell_m * most_1 / bucket_m)) + 2;
  buckets_.resize(ring);
  for (std::vector<GridCell>& bucket : buckets_) bucket.clear();
  size_t waiting = 0;
  // In ascending order of cost: the first bucket is the cheapest goal's.
  std::vector<Goal> sorted(goals.begin(), goals.end());
  std::erase_if(sorted, [&](const Goal& goal) {
    return !window_.Contains(goal.cell) || clearance.At(goal.cell) < least_m;
  });
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Goal& a, const Goal& b) { return a.cost_m < b.cost_m; });
  size_t next_goal = 0;
  const auto bucket_of = [&](float cost_m) { return static_cast<size_t>(cost_m / bucket_m); };
  const auto push = [&](GridCell cell, float cost_m) {
    cost_m_[window_.Index(cell)] = cost_m;
    buckets_[bucket_of(cost_m) % ring].push_back(cell);
    ++waiting;
  };
  for (size_t now = sorted.empty() ? 0 : bucket_of(static_cast<float>(sorted[0].cost_m));
       waiting > 0 || next_goal < sorted.size(); ++now) {
    for (; next_goal < sorted.size(); ++next_goal) {
      const Goal& goal = sorted[next_goal];
      const auto cost_m = static_cast<float>(goal.cost_m);
      if (bucket_of(cost_m) > now) break;
      if (cost_m >= cost_m_[window_.Index(goal.cell)]) continue;
      next_[window_.Index(goal.cell)] = kNoNeighbour;
      push(goal.cell, cost_m);
    }
    std::vector<GridCell>& bucket = buckets_[now % ring];
    for (size_t k = 0; k < bucket.size(); ++k) {  // may grow meanwhile
      const GridCell cell = bucket[k];
      --waiting;
      const size_t index = window_.Index(cell);
      const float cost_m = cost_m_[index];
      if (bucket_of(cost_m) != now) continue;  // was reached more cheaply before
      const bool tight = clearance.At(cell) < least_m;
      for (size_t n = 0; n < kNeighbours.size(); ++n) {
        const GridCell from{cell.x + kNeighbours[n].x, cell.y + kNeighbours[n].y};
        if (!window_.Contains(from)) continue;
        const float from_clearance_m = clearance.At(from);
        const bool from_tight = from_clearance_m < least_m;
        if (tight && !from_tight) continue;          // out, never through
        if (from_clearance_m < blocked_m) continue;  // the obstacle itself
        float per_metre_1 = 1.0F;
        if (from_tight) {
          per_metre_1 += kTight_1 - 1.0F;
        } else if (from_clearance_m < easy_m) {
          const float crowded_1 = (easy_m - from_clearance_m) / (easy_m - least_m);
          per_metre_1 += static_cast<float>(options_.crowding_1) * crowded_1 * crowded_1;
        }
        if (!grid.IsSeen(from)) per_metre_1 += static_cast<float>(options_.unseen_1);
        const float step_m = n % 2 == 0 ? cell_m : 1.41421356F * cell_m;
        const float new_cost_m = cost_m + step_m * per_metre_1;
        const size_t from_index = window_.Index(from);
        if (new_cost_m >= cost_m_[from_index]) continue;
        next_[from_index] = static_cast<uint8_t>((n + 4) % 8);
        push(from, new_cost_m);
      }
    }
    bucket.clear();
  }
}

}  // namespace geon::navigation
