#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "base/geon_label.h"
#include "base/status.h"
#include "evaluation/success_rate.h"

namespace geon::cli {

inline constexpr const char* kColorExperiment = "color";

// How one model did in one picture.
struct ColorScore {
  bool found = false;  // the centre of its target lies on the true one
  double iou_1 = 0.0;  // pixels in both masks over pixels in either
};

struct ColorOutcome {
  int t = 0;
  GeonLabel label = GeonLabel::kCuboid;
  int kelvin = 0;
  int stops = 0;
  std::string light;  // even, half in sun, shadow edge, highlight
  bool distractors = false;
  int target_pixels = 0;
  double exposure_1 = 1.0;         // that the exposure law came to, in units of the usual one
  std::vector<ColorScore> scores;  // of the record's methods, in their order
};

// A picture that a reader should see: both outlines drawn into it.
struct WorstPicture {
  int t = 0;
  ColorScore score;      // of the first method
  std::string data_uri;  // JPEG
};

// Everything geon experiment color found: what results.json holds.
struct ColorRecord {
  uint64_t seed = 1;
  std::string git;
  nlohmann::json conditions;
  std::vector<std::string> methods;
  std::string model;                   // the first method's, as its file says it
  std::vector<ColorOutcome> outcomes;  // by rising t
  std::vector<WorstPicture> worst;     // the worst first
};

// The twelve worst by the first method: the target not found, else the smallest overlap; of equals
// the lower t.
void AddWorstPicture(WorstPicture picture, std::vector<WorstPicture>* worst);
// Whether AddWorstPicture would keep it.
bool IsAmongWorst(const WorstPicture& picture, const std::vector<WorstPicture>& worst);

// A part of the trials (all, one light, one geon ...) and how every method did in it.
struct ColorRow {
  std::string name;
  std::vector<evaluation::SuccessRate> found;
  std::vector<double> median_iou_1;
};
// All trials, then by colour and level of the light, light case, distractors and geon: groups of
// rows under a heading each.
std::vector<std::pair<std::string, std::vector<ColorRow>>> ColorRows(const ColorRecord& record);

// Contract geon.experiment.v1; the same bytes however the trials were spread over jobs and shards.
std::string ColorRecordText(const ColorRecord& record);
// `name` is the file's, for errors.
Result<ColorRecord> ParseColorRecord(const nlohmann::json& value, const std::string& name);
// The trials of all shards together. Errors: another seed, build, colour or conditions, or a trial
// that two of them have.
Result<ColorRecord> MergeColorRecords(const std::vector<ColorRecord>& shards);
std::string ColorTables(const ColorRecord& record);

}  // namespace geon::cli
