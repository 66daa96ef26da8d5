#include "attention/fit_color_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "base/contracts.h"

namespace geon::attention {
namespace {

constexpr int kDirections = 16;
constexpr double kBin_1 = 1.0 / kChromaticityBins;

struct WorthyBin {
  double red_1 = 0.0, green_1 = 0.0;  // its middle
  double worth_1 = 0.0;
  int cuts = 0;  // sides that leave it outside
};

// A side of the polygon: what lies beyond `offset_1` along its direction is kept.
struct Side {
  double red_1 = 0.0, green_1 = 0.0;
  std::optional<double> offset_1;    // nothing: no such side
  std::vector<std::size_t> inward;   // the bins, the one farthest along the direction first
  std::vector<double> projection_1;  // theirs, in this order
};

struct Cut {
  std::optional<double> offset_1;
  double worth_1 = 0.0;
};

class PolygonFit {
 public:
  explicit PolygonFit(const Eigen::ArrayXXd& worth_1) {
    for (int red = 0; red < kChromaticityBins; ++red) {
      for (int green = 0; green < kChromaticityBins; ++green) {
        if (worth_1(red, green) == 0.0) continue;
        bins_.push_back({(red + 0.5) * kBin_1, (green + 0.5) * kBin_1, worth_1(red, green)});
        total_1_ += worth_1(red, green);
      }
    }
    for (int k = 0; k < kDirections; ++k) sides_[static_cast<size_t>(k)] = MakeSide(k);
  }

  // Sides all round, each with nearly all that is wanted inside.
  void Enclose() {
    constexpr double kNearlyAll_1 = 0.95;
    double wanted_1 = 0.0;
    for (const WorthyBin& bin : bins_) wanted_1 += std::max(0.0, bin.worth_1);
    for (Side& side : sides_) {
      double kept_1 = 0.0;
      size_t place = 0;
      while (place + 1 < bins_.size() && kept_1 < kNearlyAll_1 * wanted_1) {
        kept_1 += std::max(0.0, bins_[side.inward[place++]].worth_1);
      }
      Place({side.projection_1[place], 0.0}, &side);
    }
    total_1_ = 0.0;
    for (const WorthyBin& bin : bins_) total_1_ += bin.cuts == 0 ? bin.worth_1 : 0.0;
  }

  void Climb() {
    constexpr double kGain_1 = 1e-4;
    constexpr int kMostCuts = 100;
    for (int cut = 0; cut < kMostCuts; ++cut) {
      Side* improved = nullptr;
      Cut best{{}, total_1_ + kGain_1};
      for (Side& side : sides_) {
        const Cut found = LoosestCut(side, 0.0);
        if (found.worth_1 <= best.worth_1) continue;
        best = found;
        improved = &side;
      }
      if (improved == nullptr) return;
      Place(best, improved);
    }
  }

  // Takes away, one by one, the sides that matter least.
  void Prune(double tolerance_1) {
    while (true) {
      Side* least = nullptr;
      double least_loss_1 = tolerance_1;
      for (Side& side : sides_) {
        if (!side.offset_1) continue;
        const double loss_1 = total_1_ - WorthWithout(side);
        if (loss_1 > least_loss_1) continue;
        least_loss_1 = loss_1;
        least = &side;
      }
      if (least == nullptr) return;
      Place({{}, total_1_ - least_loss_1}, least);
      for (Side& side : sides_) {
        if (side.offset_1) Place(LoosestCut(side, 0.0), &side);
      }
    }
  }

  void Widen(double tolerance_1) {
    for (Side& side : sides_) {
      if (side.offset_1) Place(LoosestCut(side, tolerance_1), &side);
    }
  }

  double worth_1() const { return total_1_; }

  FittedRegion Region() const {
    FittedRegion fitted;
    fitted.worth_1 = total_1_;
    for (const Side& side : sides_) {
      if (!side.offset_1) continue;
      // red and green are shares: x r + y g > offset (r + g + b).
      const double offset_1 = *side.offset_1;
      fitted.region.half_spaces.push_back(
          WholeNumbered({side.red_1 - offset_1, side.green_1 - offset_1, -offset_1, 0.0}));
    }
    return fitted;
  }

 private:
  Side MakeSide(int k) const {
    const double angle_rad = 2.0 * std::numbers::pi * k / kDirections;
    Side side{std::cos(angle_rad), std::sin(angle_rad), {}, {}, {}};
    const auto projection = [&](size_t bin) {
      return side.red_1 * bins_[bin].red_1 + side.green_1 * bins_[bin].green_1;
    };
    for (size_t bin = 0; bin < bins_.size(); ++bin) side.inward.push_back(bin);
    std::stable_sort(side.inward.begin(), side.inward.end(),
                     [&](size_t a, size_t b) { return projection(a) > projection(b); });
    for (size_t bin : side.inward) side.projection_1.push_back(projection(bin));
    return side;
  }

  bool IsCutBy(const Side& side, size_t place) const {
    return side.offset_1 && side.projection_1[place] <= *side.offset_1;
  }

  double WorthWithout(const Side& side) const {
    double sum_1 = 0.0;
    for (size_t place = 0; place < bins_.size(); ++place) {
      const WorthyBin& bin = bins_[side.inward[place]];
      if (bin.cuts == (IsCutBy(side, place) ? 1 : 0)) sum_1 += bin.worth_1;
    }
    return sum_1;
  }

  // Where this side keeps the most between the others; of those that keep at most `tolerance_1`
  // less, the farthest out.
  Cut LoosestCut(const Side& side, double tolerance_1) const {
    std::vector<std::pair<double, double>> kept;  // last projection kept, worth up to there
    double sum_1 = 0.0;
    for (size_t place = 0; place < bins_.size(); ++place) {
      const WorthyBin& bin = bins_[side.inward[place]];
      if (bin.cuts != (IsCutBy(side, place) ? 1 : 0)) continue;
      sum_1 += bin.worth_1;
      // Bins in line across the direction go together, whatever rounding says.
      const double projection_1 = side.projection_1[place];
      if (!kept.empty() && kept.back().first - projection_1 < 1e-9) {
        kept.back().second = sum_1;
      } else {
        kept.emplace_back(projection_1, sum_1);
      }
    }
    if (kept.empty()) return {{}, 0.0};
    const auto less = [](const auto& a, const auto& b) { return a.second < b.second; };
    const double enough_1 = std::max_element(kept.begin(), kept.end(), less)->second - tolerance_1;
    size_t last = kept.size() - 1;
    while (kept[last].second < enough_1) --last;
    if (last + 1 == kept.size()) return {{}, kept[last].second};
    return {0.5 * (kept[last].first + kept[last + 1].first), kept[last].second};
  }

  void Place(const Cut& cut, Side* side) {
    for (size_t place = 0; place < bins_.size(); ++place) {
      if (IsCutBy(*side, place)) --bins_[side->inward[place]].cuts;
    }
    side->offset_1 = cut.offset_1;
    for (size_t place = 0; place < bins_.size(); ++place) {
      if (IsCutBy(*side, place)) ++bins_[side->inward[place]].cuts;
    }
    total_1_ = cut.worth_1;
  }

  std::vector<WorthyBin> bins_;
  std::array<Side, kDirections> sides_;
  double total_1_ = 0.0;  // of the bins inside all sides
};

}  // namespace

ChromaticityBin BinOf(const Rgb& pixel) {
  const int sum = pixel.red + pixel.green + pixel.blue;
  const auto bin = [sum](int channel) {
    return std::min(channel * kChromaticityBins / sum, kChromaticityBins - 1);
  };
  return {bin(pixel.red), bin(pixel.green)};
}

FittedRegion FitColorRegion(const Eigen::ArrayXXd& worth_1, double tolerance_1) {
  Require(worth_1.rows() == kChromaticityBins && worth_1.cols() == kChromaticityBins,
          "FitColorRegion: the worth has another number of bins");
  if ((worth_1 == 0.0).all()) return {};
  // From outside and from inside: either climb may end on a lower hill.
  PolygonFit fit(worth_1);
  PolygonFit other_fit = fit;
  other_fit.Enclose();
  fit.Climb();
  other_fit.Climb();
  if (other_fit.worth_1() > fit.worth_1()) fit = std::move(other_fit);
  fit.Prune(tolerance_1);
  fit.Widen(tolerance_1);
  return fit.Region();
}

}  // namespace geon::attention
