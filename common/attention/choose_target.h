#pragma once

#include <optional>
#include <span>
#include <string>

#include "attention/blobs.h"

namespace geon::attention {

struct ChoiceOptions {
  // A geon fills at least so much of its box: a bent one least. Blobs that fill less count the less
  // for it, with the square of the ratio.
  double geon_fill_1 = 0.4;
  // The longer side of a geon's box over the shorter, at most; longer blobs count the less
  // likewise.
  double geon_aspect_1 = 5.0;
  // What a blob counts that leaves the image, where a whole one counts 1: half a thing.
  double cut_off_1 = 0.5;

  // What is wrong with the values; nothing when they are good.
  std::optional<std::string> Validate() const;
};

// How much a blob speaks for a geon: its pixels, less where its shape is none a geon shows, such as
// the edge of a door or a line on the floor.
double GeonScore(const Blob& blob, int image_width_px, int image_height_px,
                 const ChoiceOptions& options);

// The blob of the highest score among those of at least `min_pixels`, if any; of equal ones the
// first.
//
// Source: the thesis takes the largest blob (4.2.1); this is the largest among blobs of a geon's
// shape.
std::optional<size_t> ChooseTarget(std::span<const Blob> blobs, int image_width_px,
                                   int image_height_px, int min_pixels,
                                   const ChoiceOptions& options);

}  // namespace geon::attention
