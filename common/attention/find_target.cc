#include "attention/find_target.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <optional>
#include <utility>

#include "attention/resolve_color.h"
#include "base/contracts.h"

namespace geon::attention {
namespace {

// The groups' numbers, largest blob first; of equal ones the upper left first.
std::vector<size_t> LargestFirst(const std::vector<Blob>& blobs) {
  std::vector<size_t> order(blobs.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&blobs](size_t one, size_t other) {
    return blobs[one].pixels > blobs[other].pixels;
  });
  return order;
}

void Paint(const PixelGroups& groups, int group, int width_px, std::vector<uint8_t>* mask) {
  for (const PixelRun& run : groups.runs) {
    if (run.group != group) continue;
    uint8_t* row = mask->data() + static_cast<size_t>(run.v_px) * static_cast<size_t>(width_px);
    std::memset(row + run.u_begin_px, 255, static_cast<size_t>(run.u_end_px - run.u_begin_px));
  }
}

int CountInBox(const BitMask& mask, const sensor::PixelBox& box) {
  int count = 0;
  for (int v = box.v_px; v < box.v_px + box.h_px; ++v) {
    count += mask.Count(v, box.u_px, box.u_px + box.w_px);
  }
  return count;
}

}  // namespace

std::optional<std::string> AttentionOptions::Validate() const {
  if (erosion_neighbors != 4 && erosion_neighbors != 8) {
    return "erosion_neighbors is " + std::to_string(erosion_neighbors) + ", must be 4 or 8";
  }
  if (min_target_pixels < 1) {
    return "min_target_pixels is " + std::to_string(min_target_pixels) + ", must be at least 1";
  }
  if (clipped_level < 1 || clipped_level > 255) {
    return "clipped_level is " + std::to_string(clipped_level) + ", must be 1 ... 255";
  }
  return choice.Validate();
}

TargetFinder::TargetFinder(ColorModel model, const AttentionOptions& options, SimdLevel level)
    : options_(options), classifier_(std::move(model), level) {
  const std::optional<std::string> error = options.Validate();
  Require(!error, "AttentionOptions: " + error.value_or(""));
}

TargetSighting TargetFinder::Find(const sensor::Image& image, const Accepts& accepts) const {
  TargetSighting sighting;
  sighting.width_px = image.width_px;
  sighting.height_px = image.height_px;

  PixelClasses classes = classifier_.Classify(image, options_.clipped_level);  // 4.1.2
  const BitMask lost = std::move(classes.lost);
  const BitMask colored = ResolveColor(std::move(classes));
  sighting.color_pixels = colored.Count();
  const PixelGroups groups = GroupPixels(Erode(colored, options_.erosion_neighbors));  // 4.2.1
  const std::vector<Blob> blobs = MeasureBlobs(groups);
  const std::vector<size_t> order = LargestFirst(blobs);
  sighting.blobs.reserve(blobs.size());
  for (const size_t group : order) sighting.blobs.push_back(blobs[group]);

  sighting.mask.assign(static_cast<size_t>(image.width_px) * static_cast<size_t>(image.height_px),
                       0);
  std::vector<Blob> candidates;
  std::vector<size_t> places;  // of the candidates in `blobs`
  for (size_t k = 0; k < sighting.blobs.size(); ++k) {
    if (accepts && !accepts(sighting.blobs[k])) continue;
    candidates.push_back(sighting.blobs[k]);
    places.push_back(k);
  }
  const std::optional<size_t> chosen = ChooseTarget(candidates, image.width_px, image.height_px,
                                                    options_.min_target_pixels, options_.choice);
  if (!chosen) return sighting;
  const size_t index = places[*chosen];
  const int target = static_cast<int>(order[index]);
  const auto place = sighting.blobs.begin() + static_cast<std::ptrdiff_t>(index);
  std::rotate(sighting.blobs.begin(), place, place + 1);
  sighting.target = sighting.blobs.front();
  const sensor::PixelBox& box = sighting.target->box;
  Paint(groups, target, image.width_px, &sighting.mask);
  sighting.bottom_px = BottomPoint(groups, target);
  sighting.touched = {box.u_px == 0, box.u_px + box.w_px == image.width_px, box.v_px == 0,
                      box.v_px + box.h_px == image.height_px};
  sighting.clipped_pixels = CountInBox(lost, box);
  return sighting;
}

TargetSighting FindTarget(const sensor::Image& image, const ColorModel& model,
                          const AttentionOptions& options) {
  return TargetFinder(model, options).Find(image);
}

}  // namespace geon::attention
