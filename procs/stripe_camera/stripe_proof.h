#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sensor/image.h"
#include "sensor/stripe.h"

namespace geon::stripe_camera {

struct StripeProofOptions {
  double min_peak_level = 12.0;      // grey levels above the unlit frame
  double min_peak_to_noise_1 = 6.0;  // and in units of the difference's noise
  int min_lit_lines = 24;            // columns (rows for the vertical laser) that reach it
};

// Whether a difference of frames shows the stripe of the laser that was on.
struct StripeProof {
  bool lit = false;
  double peak_level = 0.0;   // reached in min_lit_lines lines at least
  double noise_level = 0.0;  // robust standard deviation of the difference
  int lit_columns = 0;
  int lit_rows = 0;
  std::string reason;  // why not, empty when lit
};

// Sums frames of one size; the mean difference of two sums is what a stripe is measured in.
class FrameSum {
 public:
  void Add(const sensor::Image& grey);
  void Clear();
  int count() const { return count_; }
  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }
  // Mean of `lit` minus mean of this, rounded, signed; both of the same size and not empty.
  std::vector<int16_t> MeanDifference(const FrameSum& lit) const;

 private:
  std::vector<uint32_t> sum_;
  int count_ = 0;
  int width_px_ = 0;
  int height_px_ = 0;
};

// A frame above the median of its levels, in place of a difference where there is no unlit frame:
// of what the room's light shows, little passes the camera's filter.
std::vector<int16_t> AboveMedian(const sensor::Image& grey);

// Looks at the signed difference: a stripe of the horizontal laser stands out in many columns and
// in few rows, that of the vertical one the other way round. What is brighter everywhere (lamp
// flicker) is taken off first.
StripeProof ProveStripe(const std::vector<int16_t>& difference, int width_px, int height_px,
                        sensor::Laser laser, const StripeProofOptions& options);

// The difference as an image, negative values to 0 (errata to thesis equation 3.6).
sensor::Image SaturatedDifference(const std::vector<int16_t>& difference, int width_px,
                                  int height_px);

}  // namespace geon::stripe_camera
