#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "attention/color_model.h"
#include "base/status.h"
#include "sensor/image.h"

namespace geon::cli {

// A picture as kBgr8, pixels as stored (no rotation by metadata). Missing, foreign, truncated or
// damaged files are errors.
Result<sensor::Image> LoadImage(const std::filesystem::path& file);

// A mask of the same file formats: non-zero where any channel is.
Result<std::vector<uint8_t>> LoadMask(const std::filesystem::path& file, int width_px,
                                      int height_px);

// Writes 8-bit grey levels, width x height, as PNG.
Status SaveGrayPng(const std::filesystem::path& file, const std::vector<uint8_t>& gray,
                   int width_px, int height_px);

// The colour model of that name, or in that file.
Result<attention::ColorModel> LoadColorModel(const std::string& name_or_file);

}  // namespace geon::cli
