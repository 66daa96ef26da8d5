#include "recognition/explain_evidence.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "base/plain_name.h"

namespace geon::recognition {
namespace {

using sensor::GeonVerdict;
using sensor::Laser;
using sensor::ProfileEvidence;

constexpr double kWorthNaming = 0.02;  // a label with less of the posterior is not named

std::string Whole(double value) { return std::to_string(std::lround(value)); }

std::string BendingWords(const GeonVerdict& verdict) {
  const sensor::BendingEvidence& bending = verdict.bending;
  std::string words;
  if (bending.two_segments) words += " a profile falls into two segments;";
  if (bending.concavity) words += " a profile has a concave part;";
  if (bending.concave_edge) {
    words +=
        " end points lie " + Whole(1e3 * bending.concave_edge_m) + " mm inside a straight edge;";
  }
  if (words.empty()) return "bending: no sign of it.";
  words.back() = '.';
  return "bending:" + words;
}

// "3 horizontal lengths 98, 112, 131 mm (+14 %, +17 %)".
std::string LengthWords(const GeonVerdict& verdict, Laser laser, const char* name) {
  std::string lengths, growth;
  double before_m = 0.0;
  int count = 0;
  for (const ProfileEvidence& profile : verdict.profiles) {
    if (profile.laser != laser || profile.segments == 0) continue;
    lengths += (count > 0 ? ", " : "") + Whole(1e3 * profile.length_m);
    if (before_m > 0.0) {
      const long percent = std::lround(100.0 * (profile.length_m / before_m - 1.0));
      growth += (growth.empty() ? "" : ", ") + std::string(percent >= 0 ? "+" : "") +
                std::to_string(percent) + " %";
    }
    before_m = profile.length_m;
    ++count;
  }
  if (count == 0) return std::string("no ") + name + " stripe on the target";
  return std::to_string(count) + " " + name + " lengths " + lengths + " mm" +
         (growth.empty() ? "" : " (" + growth + ")");
}

std::string TaperingWords(const GeonVerdict& verdict) {
  return "tapering: " + LengthWords(verdict, Laser::kHorizontal, "horizontal") + "; " +
         LengthWords(verdict, Laser::kVertical, "vertical") + ".";
}

std::string ProfileWords(const GeonVerdict& verdict) {
  int seen = 0, curved = 0, cornered = 0;
  for (const ProfileEvidence& profile : verdict.profiles) {
    if (profile.segments == 0) continue;
    ++seen;
    curved += profile.curves > 0 ? 1 : 0;
    cornered += profile.corners > 0 ? 1 : 0;
  }
  const std::string of = " of " + std::to_string(seen) + " profiles";
  return "surface: curves in " + std::to_string(curved) + of + ", corners in " +
         std::to_string(cornered) + ".";
}

std::string PosteriorWords(const GeonVerdict& verdict) {
  std::array<size_t, kGeonLabelCount> order{};
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return verdict.posterior[a] > verdict.posterior[b]; });
  std::string words = "weighed together:";
  for (size_t k : order) {
    if (verdict.posterior[k] < kWorthNaming && k != order[0]) continue;
    words += " " + PlainName(static_cast<GeonLabel>(k)) + " " +
             Whole(100.0 * verdict.posterior[k]) + " %,";
  }
  words.back() = '.';
  return words;
}

}  // namespace

std::vector<std::string> ExplainEvidence(const GeonVerdict& verdict) {
  return {BendingWords(verdict), TaperingWords(verdict), ProfileWords(verdict),
          PosteriorWords(verdict)};
}

}  // namespace geon::recognition
