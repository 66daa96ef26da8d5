#include "evaluation/scan_conditions.h"

#include "base/angles.h"

namespace geon::evaluation {
namespace {

Stress Named(const char* name, double FaultOptions::*fault, double value) {
  Stress stress{name, {}};
  stress.faults.*fault = value;
  return stress;
}

}  // namespace

const std::vector<Stress>& Stresses() {
  static const std::vector<Stress> stresses = [] {
    std::vector<Stress> all = {
        {"none", {}},
        Named("outliers", &FaultOptions::outliers_1, 0.02),
        Named("dropout", &FaultOptions::dropout_1, 0.10),
        Named("speckle", &FaultOptions::speckle_px, 0.15),
        Named("floor_cut", &FaultOptions::floor_cut_m, 0.015),
        Named("attitude", &FaultOptions::attitude_rad, RadiansFromDegrees(1.5)),
        Named("misplacement", &FaultOptions::misplacement_1, 0.05),
        {"small", {}, false, 0.6},
        Named("realish", &FaultOptions::misplacement_1, 0.03),
    };
    all.back().floor = true;
    return all;
  }();
  return stresses;
}

std::optional<Stress> FindStress(std::string_view name) {
  for (const Stress& stress : Stresses()) {
    if (stress.name == name) return stress;
  }
  return std::nullopt;
}

}  // namespace geon::evaluation
