#pragma once

#include <string>

#include "sensor/geon_verdict.h"

namespace geon::cli {

// A verdict for people: the name and how sure on the first line, then the reasons, one a line.
std::string VerdictText(const sensor::GeonVerdict& verdict);

// "tapered cylinder".
std::string PlainName(GeonLabel label);
// "a tapered cylinder", "an ellipsoid".
std::string WithArticle(GeonLabel label);

}  // namespace geon::cli
