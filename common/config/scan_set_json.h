#pragma once

#include <filesystem>
#include <string>

#include "base/status.h"
#include "sensor/scan_set.h"

namespace geon::config {

// The file format geon.scan_set.v1 (docs/channels.md): what stripes measured, frame L, metres.
//
// Reading is strict about what is there and needed: an error names the file and the place as a JSON
// pointer ("x.json: /stripes/2/pixel/17: must be larger than its predecessor"). Keys nobody knows
// are passed over, so that who makes scan sets may add notes.
Result<sensor::ScanSet> LoadScanSet(const std::filesystem::path& file);

// The same from text; `name` stands for the file in messages.
Result<sensor::ScanSet> ParseScanSet(const std::string& text, const std::string& name);

// One JSON object. Parsing it gives the same scan set, except for what the format does not hold:
// scan_id, utime, seq, attempt, status and on_target.
std::string SerializeScanSet(const sensor::ScanSet& scan);

}  // namespace geon::config
