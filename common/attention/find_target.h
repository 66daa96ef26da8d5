#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "attention/blobs.h"
#include "attention/choose_target.h"
#include "attention/classify_pixels.h"
#include "attention/color_model.h"
#include "sensor/image.h"

namespace geon::attention {

struct AttentionOptions {
  // Thesis 4.2.1: a pixel with a background pixel "connected to it" is eroded. 8 (default) or 4.
  // Pixels outside the image are not background: a target that leaves the image stays at its edge.
  int erosion_neighbors = 8;
  // "A blob large enough to be considered a geon" (4.2.2), after erosion.
  int min_target_pixels = 60;
  ChoiceOptions choice;  // between several blobs
  // A pixel with a channel at or above this level is clipped: its colour is lost.
  int clipped_level = 250;

  // What is wrong with the values; nothing when they are good.
  std::optional<std::string> Validate() const;
};

struct TouchedEdges {
  bool left = false, right = false, top = false, bottom = false;
  bool any() const { return left || right || top || bottom; }
};

// What one colour image shows of the target.
struct TargetSighting {
  int width_px = 0;
  int height_px = 0;
  std::vector<Blob> blobs;  // of the target's colour, after erosion; the target first,
                            // the others by size
  int color_pixels = 0;     // of the target's colour, before erosion

  // The blob chosen (choose_target.h); the rest below is about it, and empty without it.
  std::optional<Blob> target;
  std::vector<uint8_t> mask;                            // width x height, 255 on the target, else 0
  Eigen::Vector2d bottom_px = Eigen::Vector2d::Zero();  // its bottommost point (u, v)
  TouchedEdges touched;
  int clipped_pixels = 0;  // clipped pixels inside its box: light the exposure lost
};

// Segments images by colour, lets the pixels around settle what colour alone does not say
// (resolve_color.h), erodes, and chooses a blob.
//
// Source: thesis 4.1.2 (binarisation), 4.2.1 (erosion, blob analysis), 4.2.3 (point x).
class TargetFinder {
 public:
  // Throws ContractViolation for bad options or a bad model. `level` is for comparisons.
  TargetFinder(ColorModel model, const AttentionOptions& options,
               SimdLevel level = SimdLevels().back());

  // Which blobs may be the target; an empty function accepts all.
  using Accepts = std::function<bool(const Blob&)>;
  // Input: kRgb8 or kBgr8. Throws ContractViolation for other formats and for a size that does not
  // fit the data.
  TargetSighting Find(const sensor::Image& image, const Accepts& accepts = {}) const;

 private:
  AttentionOptions options_;
  PixelClassifier classifier_;
};

// The same for one image.
TargetSighting FindTarget(const sensor::Image& image, const ColorModel& model,
                          const AttentionOptions& options = {});

}  // namespace geon::attention
