#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>

#include "recognition/evidence_list.h"

namespace geon::recognition {

// The value of that name; throws std::out_of_range when there is none.
inline double ValueOf(const EvidenceList& evidence, const std::string& name) {
  const auto& names = evidence.names();
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) throw std::out_of_range(name);
  return evidence.values()[static_cast<size_t>(at - names.begin())];
}

}  // namespace geon::recognition
