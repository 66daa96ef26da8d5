#pragma once

#include <algorithm>
#include <string>

#include "base/geon_label.h"

namespace geon {

// A label as people read it: "tapered cylinder".
inline std::string PlainName(GeonLabel label) {
  std::string name(ToString(label));
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace geon
