#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sensor/image.h"
#include "sensor/stripe.h"

namespace geon::rangefinder {

// A grey image as lines across the stripe: the columns of a horizontal one, the rows of a vertical
// one. A view; the image must outlive it.
struct LineView {
  const uint8_t* data = nullptr;
  int lines = 0;
  int length = 0;     // pixels of a line
  int line_step = 0;  // bytes from one line to the next
  int pixel_step = 0;

  LineView(const sensor::Image& gray, sensor::Laser laser);
  const uint8_t* Line(int line) const { return data + static_cast<ptrdiff_t>(line) * line_step; }
  int At(int line, int pixel) const {
    return Line(line)[static_cast<ptrdiff_t>(pixel) * pixel_step];
  }
};

// Pixels [first, last] of one line.
struct Run {
  int line = 0;
  int first = 0;
  int last = 0;
  int length() const { return last - first + 1; }
};

// Where each line reaches `level_1`, which must not be 0: sorted by line, then by first pixel. A
// single darker pixel (noise) does not end a run.
//
// Source: ours. One sweep over the image in the order of memory, whichever way the stripe lies;
// only the ends of runs cost more than reading.
std::vector<Run> FindRuns(const sensor::Image& gray, sensor::Laser laser, uint8_t level_1);

}  // namespace geon::rangefinder
