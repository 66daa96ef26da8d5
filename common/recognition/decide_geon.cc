#include "recognition/decide_geon.h"

#include <algorithm>
#include <cstdio>
#include <string>

namespace geon::recognition {
namespace {

using sensor::BendingEvidence;
using sensor::GeonVerdict;
using sensor::TaperingEvidence;

// A question of the tree: its answer and how many observations speak for it.
struct Answer {
  bool yes = false;
  int support = 0;
  double yes_probability() const {
    const double own = (support + 1.0) / (support + 2.0);
    return yes ? own : 1.0 - own;
  }
};

// Any clue will do: `fired` of `clues` speak for yes, all silent ones for no.
Answer AnyOf(int fired, int clues) {
  return fired > 0 ? Answer{true, fired} : Answer{false, clues};
}

// More than `limit` of `count`: how many observations would have to differ to turn the answer.
Answer MoreThan(int limit, int count) {
  return count > limit ? Answer{true, count - limit} : Answer{false, limit + 1 - count};
}

std::string Number(const char* format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string Join(const std::vector<std::string>& parts) {
  std::string text;
  for (size_t i = 0; i < parts.size(); ++i) text += (i > 0 ? ", " : "") + parts[i];
  return text;
}

std::string BendingReason(const BendingEvidence& bending) {
  std::vector<std::string> clues;
  if (bending.two_segments) clues.emplace_back("a profile falls into two segments");
  if (bending.concavity) clues.emplace_back("a profile has a concave part");
  if (bending.concave_edge) {
    clues.push_back("end points lie " + Number("%.0f", bending.concave_edge_m * 1e3) +
                    " mm inside a straight edge (5.3)");
  }
  if (clues.empty()) {
    return "Not bent: no profile in two segments, none concave, no concave edge.";
  }
  return "Bent: " + Join(clues) + ".";
}

std::string TaperingReason(const TaperingEvidence& tapering) {
  std::vector<std::string> clues;
  if (tapering.monotone_horizontal) {
    clues.emplace_back("horizontal profiles change length steadily (5.4, 5.5)");
  }
  if (tapering.monotone_vertical) {
    clues.emplace_back("vertical profiles change length steadily (5.6, 5.7)");
  }
  if (tapering.asymmetric_ends) {
    clues.push_back("opposite ends step unequally by " +
                    Number("%.0f", tapering.asymmetry_m * 1e3) + " mm (5.8)");
  }
  if (clues.empty()) return "Not tapered: lengths do not change steadily and ends step equally.";
  return "Tapered: " + Join(clues) + ".";
}

std::string Count(int count, int of, const char* what) {
  return std::to_string(count) + " of " + std::to_string(of) + " profiles " + what;
}

// What the tree asks about the profiles as a whole.
struct Counts {
  int profiles = 0;
  int curved = 0;
  int cornered = 0;
};

Counts CountProfiles(const GeonVerdict& verdict) {
  Counts counts;
  for (const sensor::ProfileEvidence& profile : verdict.profiles) {
    if (profile.segments == 0) continue;
    ++counts.profiles;
    if (profile.curves > 0) ++counts.curved;
    if (profile.corners > 0) ++counts.cornered;
  }
  return counts;
}

}  // namespace

void DecideGeon(GeonVerdict* verdict) {
  const Counts counts = CountProfiles(*verdict);
  const BendingEvidence& bending = verdict->bending;
  const TaperingEvidence& tapering = verdict->tapering;
  const Answer bent =
      AnyOf(int{bending.two_segments} + int{bending.concavity} + int{bending.concave_edge}, 3);
  const Answer mostly_curved = MoreThan(counts.profiles / 2, counts.curved);
  const Answer tapered = AnyOf(int{tapering.monotone_horizontal} + int{tapering.monotone_vertical} +
                                   int{tapering.asymmetric_ends},
                               3);
  const Answer twice_curved = MoreThan(1, counts.curved);
  const Answer curved = AnyOf(counts.curved, counts.profiles);
  const Answer cornered = AnyOf(counts.cornered, counts.profiles);
  const Answer all_curved = MoreThan(std::max(counts.profiles - 1, 0), counts.curved);

  // The walk (figure 5.17).
  auto& reasons = verdict->reasons;
  reasons = {BendingReason(bending)};
  if (bent.yes) {
    verdict->label = mostly_curved.yes ? GeonLabel::kBentCylinder : GeonLabel::kBentCuboid;
    reasons.push_back(
        Count(counts.curved, counts.profiles, "curved: ") +
        (mostly_curved.yes ? "more than half, a cylinder." : "at most half, a cuboid."));
  } else if (reasons.push_back(TaperingReason(tapering)); tapered.yes) {
    verdict->label = twice_curved.yes ? GeonLabel::kTaperedCylinder : GeonLabel::kTaperedCuboid;
    reasons.push_back(Count(counts.curved, counts.profiles, "curved: ") +
                      (twice_curved.yes ? "more than one, a cylinder." : "at most one, a cuboid."));
  } else if (!curved.yes) {
    verdict->label = GeonLabel::kCuboid;
    reasons.emplace_back("No profile is curved: a cuboid.");
  } else if (cornered.yes) {
    verdict->label = GeonLabel::kCylinder;
    reasons.push_back(Count(counts.curved, counts.profiles, "curved, ") +
                      std::to_string(counts.cornered) + " with a corner: a cylinder.");
  } else {
    verdict->label = all_curved.yes ? GeonLabel::kEllipsoid : GeonLabel::kCylinder;
    reasons.push_back(Count(counts.curved, counts.profiles, "curved, none with a corner: ") +
                      (all_curved.yes ? "all, an ellipsoid." : "not all, a cylinder."));
  }

  // The posterior: every way through the tree.
  auto& p = verdict->posterior;
  const auto share = [&p](GeonLabel label, double probability) {
    p[static_cast<size_t>(label)] += probability;
  };
  p.fill(0.0);
  const double is_bent = bent.yes_probability();
  share(GeonLabel::kBentCylinder, is_bent * mostly_curved.yes_probability());
  share(GeonLabel::kBentCuboid, is_bent * (1.0 - mostly_curved.yes_probability()));
  const double is_tapered = (1.0 - is_bent) * tapered.yes_probability();
  share(GeonLabel::kTaperedCylinder, is_tapered * twice_curved.yes_probability());
  share(GeonLabel::kTaperedCuboid, is_tapered * (1.0 - twice_curved.yes_probability()));
  const double is_plain = (1.0 - is_bent) * (1.0 - tapered.yes_probability());
  share(GeonLabel::kCuboid, is_plain * (1.0 - curved.yes_probability()));
  const double is_round = is_plain * curved.yes_probability();
  share(GeonLabel::kCylinder, is_round * cornered.yes_probability());
  const double is_smooth = is_round * (1.0 - cornered.yes_probability());
  share(GeonLabel::kEllipsoid, is_smooth * all_curved.yes_probability());
  share(GeonLabel::kCylinder, is_smooth * (1.0 - all_curved.yes_probability()));
  verdict->confidence = p[static_cast<size_t>(verdict->label)];
}

}  // namespace geon::recognition
