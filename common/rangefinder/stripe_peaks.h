#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sensor/image.h"
#include "sensor/stripe.h"

namespace geon::rangefinder {

// How a peak is measured.
enum class PeakMethod {
  kCentroid,  // the thesis's equation 3.6, in a window: the baseline
  kGaussian,  // a Gaussian profile, by moments or, where saturated, by logarithms (stripe_fit.h)
};
std::string_view ToString(PeakMethod method);
std::optional<PeakMethod> PeakMethodFromString(std::string_view name);

struct PeakOptions {
  PeakMethod method = PeakMethod::kGaussian;
  double min_peak_1 = 12.0;      // grey levels above the background; fainter is no laser light
  double noise_factor_1 = 6.0;   // and this many standard deviations of the image's noise
  double base_fraction_1 = 0.2;  // of the peak: what lies below the centroid does not weigh (3.6)
  // Of the centroid, widened for a stripe that is wider; fainter spots as near to a brighter one
  // are no peaks of their own.
  int half_window_px = 7;
  int max_width_px = 20;   // at half height; wider is glare
  int max_step_px = 3;     // between neighbours on one unbroken piece of the stripe
  int max_gap_px = 2;      // columns (rows) missing inside a piece
  int min_piece_px = 6;    // shorter pieces are specks
  int max_candidates = 4;  // bright spots considered in one column (row)
  // Of the stripe's median brightness; fainter pieces are light scattered by what the stripe hits.
  double min_relative_peak_1 = 0.2;
  // Of an image that may show no stripe at all: the share of lines with a peak times the share of
  // all the light found that these peaks hold; below it nothing is a stripe. 0 where the light is
  // known to be a laser's, as in the difference of a lit and an unlit frame.
  double min_stripe_share_1 = 0.0;

  std::optional<std::string> Validate() const;
};

// What became of one column (horizontal stripe) or row (vertical stripe).
enum class PeakReason {
  kFound = 0,
  kTooFaint = 1,   // nothing brighter than noise and threshold
  kTooWide = 2,    // glare: a bright area, no line
  kSpeck = 3,      // bright, but on no piece of stripe long enough
  kAmbiguous = 4,  // two pieces of stripe claim it with equal right
  kNoStripe = 5,   // the image's bright lines are too many and too broken to be one stripe
};
std::string_view ToString(PeakReason reason);

// All but `pixel` and `reason` are 0 unless kFound.
struct StripePeak {
  int pixel = 0;  // column of a horizontal stripe, row of a vertical one
  PeakReason reason = PeakReason::kTooFaint;
  double position_px = 0.0;  // row, or column, of the stripe's centre
  double peak_1 = 0.0;       // grey levels above what it stands on; beyond 255 if saturated
  double width_px = 0.0;     // of the stripe: standard deviation of its brightness profile
  double sigma_px = 0.0;     // standard error of position_px, from the image's noise
};

// Finds the stripe in an image of laser light: one entry per column (horizontal) or row (vertical),
// in order.
//
// Source: thesis 3.1. Its equation 3.6 (kCentroid) as the errata say: the centroid in a window
// round the peak of the lit minus the unlit image; the whole column of a raw image pulls it to the
// image's centre. Deviations: by default a Gaussian profile is measured (kGaussian). Of several
// bright spots in a column that one is taken which lies on the strongest unbroken piece of stripe,
// and spots on none are refused, so that specks and reflections are not measured. sigma_px follows
// from the noise of the background and from how the profiles scatter about the Gaussian, both
// measured in this image. Input: kGray8. Throws ContractViolation for other formats or bad options.
std::vector<StripePeak> FindStripePeaks(const sensor::Image& laser_light, sensor::Laser laser,
                                        const PeakOptions& options = {});

}  // namespace geon::rangefinder
