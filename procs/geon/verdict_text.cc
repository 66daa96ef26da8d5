#include "procs/geon/verdict_text.h"

#include <cmath>

namespace geon::cli {

std::string WithArticle(GeonLabel label) {
  return (label == GeonLabel::kEllipsoid ? "an " : "a ") + PlainName(label);
}

std::string VerdictText(const sensor::GeonVerdict& verdict) {
  std::string text = PlainName(verdict.label) + " (confidence " +
                     std::to_string(std::lround(100.0 * verdict.confidence)) + " %" +
                     (verdict.decided ? "" : ", no more than a guess") + ")\n";
  for (const std::string& reason : verdict.reasons) text += "  " + reason + "\n";
  return text;
}

}  // namespace geon::cli
