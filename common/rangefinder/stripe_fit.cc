#include "rangefinder/stripe_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "rangefinder/stripe_moments.h"

namespace geon::rangefinder {
namespace {

int BrightestOf(const LineView& image, const Run& run) {
  int brightest = 0;
  for (int i = run.first; i <= run.last; ++i)
    brightest = std::max(brightest, image.At(run.line, i));
  return brightest;
}

// Least squares of c0 + c1 x + c2 x^2 through the logarithms of the pixels that rise above noise
// and do not belong to the clipped crest.
std::optional<ProfileFit> FitByLogarithms(const LineView& image, const Run& run, int brightest,
                                          double noise_1) {
  constexpr double kCrest = 3.0;  // standard deviations below the brightest: may be clipped
  constexpr double kRise = 2.0;   // standard deviations above the floor
  const int flank = std::max(4, run.length() / 3);
  const int first = std::max(0, run.first - flank);
  const int last = std::min(image.length - 1, run.last + flank);
  const double floor_1 = FloorBeside(image, run.line, first, last, noise_1);
  const double middle_px = 0.5 * (run.first + run.last);
  const double crest_1 = std::min(double{kSaturated}, brightest - kCrest * noise_1);
  int core_first = run.first;
  while (image.At(run.line, core_first) < crest_1) ++core_first;
  int core_last = run.last;
  while (image.At(run.line, core_last) < crest_1) --core_last;
  double s[5] = {};  // sums of weight x^k
  double t[3] = {};  // sums of weight log x^k
  double light = 0.0;
  int used[2] = {0, 0};  // on either side
  for (int i = first; i <= last; ++i) {
    const double y = image.At(run.line, i) - floor_1;
    if ((i >= core_first && i <= core_last) || y < kRise * noise_1 + 1.0) continue;
    const double x = i - middle_px;
    const double weight = y * y;
    const double log_y = std::log(y);
    double power = weight;
    for (int k = 0; k < 5; ++k, power *= x) {
      s[k] += power;
      if (k < 3) t[k] += power * log_y;
    }
    light += weight * y;
    ++used[x < 0.0 ? 0 : 1];
  }
  if (std::min(used[0], used[1]) < 2) return std::nullopt;
  // Cofactors of the symmetric matrix with rows (s0 s1 s2), (s1 s2 s3), (s2 s3 s4).
  const double a00 = s[2] * s[4] - s[3] * s[3];
  const double a01 = s[2] * s[3] - s[1] * s[4];
  const double a02 = s[1] * s[3] - s[2] * s[2];
  const double a11 = s[0] * s[4] - s[2] * s[2];
  const double a12 = s[1] * s[2] - s[0] * s[3];
  const double a22 = s[0] * s[2] - s[1] * s[1];
  const double determinant = s[0] * a00 + s[1] * a01 + s[2] * a02;
  if (!(determinant > 0.0)) return std::nullopt;
  const double c0 = (a00 * t[0] + a01 * t[1] + a02 * t[2]) / determinant;
  const double c1 = (a01 * t[0] + a11 * t[1] + a12 * t[2]) / determinant;
  const double c2 = (a02 * t[0] + a12 * t[1] + a22 * t[2]) / determinant;
  if (!(c2 < 0.0)) return std::nullopt;
  ProfileFit fit;
  const double shift_px = -0.5 * c1 / c2;
  if (std::abs(shift_px) > 0.5 * run.length()) return std::nullopt;
  fit.position_px = middle_px + shift_px;
  fit.peak_1 = std::exp(std::min(c0 + 0.5 * c1 * shift_px, 9.0));
  fit.width_px = std::sqrt(-0.5 / c2);
  fit.floor_1 = floor_1;
  // With their neighbours, which are in the fit only when their noise made them darker.
  fit.core_first = core_first - 1;
  fit.core_last = core_last + 1;
  // By c1 and c2 of the position's derivatives; a weight is the level's square, so a grey level of
  // noise counts the same in every pixel.
  fit.per_noise = (a11 + 4.0 * shift_px * a12 + 4.0 * shift_px * shift_px * a22) / determinant /
                  (4.0 * c2 * c2);
  fit.per_gain = fit.per_noise * light / s[0];
  fit.first = first;
  fit.last = last;
  return fit;
}

// Where the profile crosses `level_1` beyond pixel `inside`, towards `step`.
double Crossing(const LineView& image, int line, int inside, int step, double level_1) {
  while (inside + step >= 0 && inside + step < image.length &&
         image.At(line, inside + step) >= level_1) {
    inside += step;
  }
  if (inside + step < 0 || inside + step >= image.length) return inside + 0.5 * step;
  const double in_1 = image.At(line, inside) - level_1;
  const double out_1 = image.At(line, inside + step) - level_1;
  return inside + step * std::clamp(in_1 / (in_1 - out_1), 0.0, 1.0);
}

}  // namespace

std::optional<ProfileFit> MeasureCentroid(const LineView& image, const Run& run, double noise_1,
                                          double base_fraction_1, int half_window_px) {
  const int reach = std::max(half_window_px, run.length());
  const int middle = (run.first + run.last) / 2;
  const int first = std::max(0, middle - reach);
  const int last = std::min(image.length - 1, middle + reach);
  ProfileFit fit;
  fit.first = first;
  fit.last = last;
  fit.floor_1 = FloorBeside(image, run.line, first, last, noise_1);
  const int brightest = BrightestOf(image, run);
  fit.peak_1 = brightest - fit.floor_1;
  const double base_1 = fit.floor_1 + base_fraction_1 * fit.peak_1;
  double sum = 0.0;
  double moment = 0.0;
  for (int i = first; i <= last; ++i) {
    const double weight = std::max(0.0, image.At(run.line, i) - base_1);
    sum += weight;
    moment += weight * i;
  }
  if (!(sum > 0.0)) return std::nullopt;
  fit.position_px = moment / sum;
  for (int i = first; i <= last; ++i) {
    const double above_1 = image.At(run.line, i) - base_1;
    if (above_1 <= 0.0) continue;
    const double lever = (i - fit.position_px) / sum;
    fit.per_noise += lever * lever;
    fit.per_gain += lever * lever * (above_1 + base_1 - fit.floor_1);
  }
  const double half_1 = fit.floor_1 + 0.5 * fit.peak_1;
  int crest = run.first;
  while (image.At(run.line, crest) < brightest) ++crest;
  // A Gaussian's width at half its height, in standard deviations.
  fit.width_px =
      (Crossing(image, run.line, crest, 1, half_1) - Crossing(image, run.line, crest, -1, half_1)) /
      2.3548;
  return fit;
}

Misfit MeasureMisfit(const LineView& image, int line, const ProfileFit& fit) {
  // What a fit of three parameters takes out of the residuals: the noise of three pixels, but the
  // shot noise of 1.77 at the crest (the leverage of Gauss-Hermite functions 0 to 2). Where the
  // crest is clipped, most of it out of pixels that are left out here.
  const bool clipped = fit.core_first <= fit.core_last;
  const int fitted = clipped ? 0 : 3;
  const double fitted_light_1 = clipped ? 0.0 : 1.77 * fit.peak_1;
  constexpr double kByFloor = 0.5 / kFloorRing;  // the floor's own error, in variances of a pixel
  double square_sum = 0.0;
  double light_sum = 0.0;
  int pixels = 0;
  // From pixel to pixel a Gaussian falls by a factor that falls by a constant factor.
  const double per_pixel = 1.0 / fit.width_px;
  const double x = (fit.first - fit.position_px) * per_pixel;
  const double fall_of_fall = std::exp(-per_pixel * per_pixel);
  double fall = std::exp(-(x + 0.5 * per_pixel) * per_pixel);
  double light_1 = fit.peak_1 * std::exp(-0.5 * x * x);
  for (int i = fit.first; i <= fit.last; ++i, light_1 *= fall, fall *= fall_of_fall) {
    if (i >= fit.core_first && i <= fit.core_last) continue;
    const double residual_1 = image.At(line, i) - fit.floor_1 - light_1;
    square_sum += residual_1 * residual_1;
    light_sum += light_1;
    ++pixels;
  }
  if (pixels <= fitted) return {};
  return {square_sum, std::max(0.0, light_sum - fitted_light_1),
          pixels - fitted + kByFloor * pixels};
}

// A clipped profile: by logarithms where the flanks are a Gaussian's. Real ones often are not, for
// light scattered round a bright stripe; then by the centroid of what stands clear of that, which
// is as symmetric as the stripe.
std::optional<ProfileFit> FitClipped(const LineView& image, const Run& run, double noise_1) {
  constexpr double kBase = 0.2;     // of the clipped height
  constexpr double kMisfit = 0.02;  // of the brightest level, besides noise
  constexpr double kNoise = 2.0;
  const int brightest = BrightestOf(image, run);
  std::optional<ProfileFit> fit = FitByLogarithms(image, run, brightest, noise_1);
  if (!fit) return fit;
  const Misfit misfit = MeasureMisfit(image, run.line, *fit);
  const double tolerated_1 = kNoise * noise_1 + kMisfit * brightest;
  if (misfit.square_sum_1 <= misfit.freedom * tolerated_1 * tolerated_1) return fit;
  const auto centroid = MeasureCentroid(image, run, noise_1, kBase, 0);
  if (!centroid) return fit;
  fit->position_px = centroid->position_px;
  fit->per_noise = centroid->per_noise;
  fit->per_gain = centroid->per_gain;
  return fit;
}

std::vector<std::optional<ProfileFit>> FitGaussians(const LineView& image,
                                                    std::span<const Run> runs, double level_1,
                                                    const Background& background) {
  std::vector<std::optional<ProfileFit>> fits(runs.size());
  for (const size_t k : FitByMoments(image, runs, level_1, background, fits)) {
    fits[k] = FitClipped(image, runs[k], background.noise_1);
  }
  return fits;
}

}  // namespace geon::rangefinder
