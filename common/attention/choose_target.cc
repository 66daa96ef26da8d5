#include "attention/choose_target.h"

#include <algorithm>

namespace geon::attention {

std::optional<std::string> ChoiceOptions::Validate() const {
  if (!(geon_fill_1 > 0.0 && geon_fill_1 <= 1.0)) return "geon_fill_1 must be above 0, at most 1";
  if (!(geon_aspect_1 >= 1.0)) return "geon_aspect_1 must be at least 1";
  if (!(cut_off_1 > 0.0 && cut_off_1 <= 1.0)) return "cut_off_1 must be above 0, at most 1";
  return std::nullopt;
}

double GeonScore(const Blob& blob, int image_width_px, int image_height_px,
                 const ChoiceOptions& options) {
  const sensor::PixelBox& box = blob.box;
  const double fill_1 = blob.pixels / (static_cast<double>(box.w_px) * box.h_px);
  const double aspect_1 = static_cast<double>(std::max(box.w_px, box.h_px)) /
                          static_cast<double>(std::min(box.w_px, box.h_px));
  const double sparse_1 = std::min(1.0, fill_1 / options.geon_fill_1);
  const double long_1 = std::min(1.0, options.geon_aspect_1 / aspect_1);
  const bool is_cut_off = box.u_px == 0 || box.v_px == 0 || box.u_px + box.w_px == image_width_px ||
                          box.v_px + box.h_px == image_height_px;
  return blob.pixels * sparse_1 * sparse_1 * long_1 * long_1 *
         (is_cut_off ? options.cut_off_1 : 1.0);
}

std::optional<size_t> ChooseTarget(std::span<const Blob> blobs, int image_width_px,
                                   int image_height_px, int min_pixels,
                                   const ChoiceOptions& options) {
  std::optional<size_t> chosen;
  double best = 0.0;
  for (size_t k = 0; k < blobs.size(); ++k) {
    if (blobs[k].pixels < min_pixels) continue;
    const double score = GeonScore(blobs[k], image_width_px, image_height_px, options);
    if (score <= best) continue;
    best = score;
    chosen = k;
  }
  return chosen;
}

}  // namespace geon::attention
