#pragma once

#include <string>

#include "base/plain_name.h"
#include "sensor/geon_verdict.h"

namespace geon::cli {

// A verdict for people: the name and how sure on the first line, then the reasons, one a line.
std::string VerdictText(const sensor::GeonVerdict& verdict);

// "a tapered cylinder", "an ellipsoid".
std::string WithArticle(GeonLabel label);

}  // namespace geon::cli
