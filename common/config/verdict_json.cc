#include "config/verdict_json.h"

#include <nlohmann/json.hpp>

#include "base/geon_label.h"

namespace geon::config {
namespace {

using nlohmann::ordered_json;

ordered_json ProfileJson(const sensor::ProfileEvidence& profile) {
  return {{"laser", ToString(profile.laser)},   {"fraction", profile.fraction},
          {"points", profile.points},           {"segments", profile.segments},
          {"curves", profile.curves},           {"corners", profile.corners},
          {"concavities", profile.concavities}, {"length_m", profile.length_m}};
}

ordered_json EvidenceJson(const sensor::GeonVerdict& verdict) {
  const sensor::BendingEvidence& bending = verdict.bending;
  const sensor::TaperingEvidence& tapering = verdict.tapering;
  ordered_json evidence = {{"bending",
                            {{"found", bending.found()},
                             {"two_segments", bending.two_segments},
                             {"concavity", bending.concavity},
                             {"concave_edge", bending.concave_edge},
                             {"concave_edge_m", bending.concave_edge_m}}},
                           {"tapering",
                            {{"found", tapering.found()},
                             {"monotone_horizontal", tapering.monotone_horizontal},
                             {"monotone_vertical", tapering.monotone_vertical},
                             {"asymmetric_ends", tapering.asymmetric_ends},
                             {"asymmetry_m", tapering.asymmetry_m}}},
                           {"profiles", ordered_json::array()},
                           {"reasons", verdict.reasons}};
  for (const sensor::ProfileEvidence& profile : verdict.profiles) {
    evidence["profiles"].push_back(ProfileJson(profile));
  }
  return evidence;
}

}  // namespace

std::string SerializeVerdict(const sensor::GeonVerdict& verdict, const std::string& file,
                             int64_t microseconds) {
  ordered_json posterior;
  for (size_t i = 0; i < kGeonLabelNames.size(); ++i) {
    posterior[std::string(kGeonLabelNames[i])] = verdict.posterior[i];
  }
  const ordered_json root = {{"format", "geon.verdict.v1"},
                             {"file", file},
                             {"label", std::string(ToString(verdict.label))},
                             {"confidence", verdict.confidence},
                             {"posterior", posterior},
                             {"decided", verdict.decided},
                             {"method", verdict.method},
                             {"evidence", EvidenceJson(verdict)},
                             {"microseconds", microseconds}};
  // A file name need not be valid UTF-8.
  return root.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace geon::config
