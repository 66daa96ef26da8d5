#include "procs/geon/image_file.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "attention/color_model_text.h"
#include "config/text_file.h"

namespace geon::cli {
namespace {

// Decoders fill what a truncated JPEG lacks with grey and only mutter about it; its end marker
// tells.
bool IsTruncatedJpeg(const std::string& bytes) {
  if (bytes.compare(0, 2, "\xFF\xD8") != 0) return false;
  return bytes.rfind("\xFF\xD9") == std::string::npos;
}

}  // namespace

Result<sensor::Image> LoadImage(const std::filesystem::path& file) {
  const Result<std::string> bytes = config::ReadFile(file);
  if (!bytes.ok()) return bytes.status();
  if (bytes->empty()) return Status::Error(file.string() + ": is empty");
  if (IsTruncatedJpeg(*bytes)) {
    return Status::Error(file.string() + ": is a truncated JPEG: copy it again");
  }
  cv::Mat pixels;
  try {
    const cv::Mat encoded(1, static_cast<int>(bytes->size()), CV_8UC1,
                          const_cast<char*>(bytes->data()));
    pixels = cv::imdecode(encoded, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception& error) {
    return Status::Error(file.string() + ": cannot decode: " + error.err);
  }
  if (pixels.empty()) {
    return Status::Error(file.string() +
                         ": is no image that can be read (PNG, JPEG, BMP, TIFF, PNM), or damaged");
  }
  sensor::Image image;
  image.width_px = pixels.cols;
  image.height_px = pixels.rows;
  image.row_stride_bytes = 3 * pixels.cols;
  image.format = sensor::PixelFormat::kBgr8;
  image.data.assign(pixels.data, pixels.data + pixels.total() * 3);
  return image;
}

Result<std::vector<uint8_t>> LoadMask(const std::filesystem::path& file, int width_px,
                                      int height_px) {
  const Result<sensor::Image> image = LoadImage(file);
  if (!image.ok()) return image.status();
  if (image->width_px != width_px || image->height_px != height_px) {
    return Status::Error(file.string() + ": is " + std::to_string(image->width_px) + " x " +
                         std::to_string(image->height_px) + ", its picture " +
                         std::to_string(width_px) + " x " + std::to_string(height_px));
  }
  std::vector<uint8_t> mask(image->data.size() / 3);
  for (size_t i = 0; i < mask.size(); ++i) {
    mask[i] = std::max({image->data[3 * i], image->data[3 * i + 1], image->data[3 * i + 2]});
  }
  return mask;
}

Status SaveGrayPng(const std::filesystem::path& file, const std::vector<uint8_t>& gray,
                   int width_px, int height_px) {
  Require(gray.size() == static_cast<size_t>(width_px) * static_cast<size_t>(height_px),
          "SaveGrayPng: the data does not fit the size");
  std::vector<uint8_t> png;
  const cv::Mat pixels(height_px, width_px, CV_8UC1, const_cast<uint8_t*>(gray.data()));
  try {
    cv::imencode(".png", pixels, png);
  } catch (const cv::Exception& error) {
    return Status::Error(file.string() + ": cannot encode: " + error.err);
  }
  return config::WriteFileAtomically(file, std::string(png.begin(), png.end()));
}

Result<attention::ColorModel> LoadColorModel(const std::string& name_or_file) {
  if (auto named = attention::NamedColorModel(name_or_file)) return *named;
  if (!std::filesystem::exists(name_or_file)) {
    std::string names;
    for (const std::string& name : attention::NamedColorModels()) names += " " + name;
    return Status::Error(name_or_file + ": neither a file nor a colour; colours:" + names);
  }
  const Result<std::string> text = config::ReadFile(name_or_file, 1U << 20U);
  if (!text.ok()) return text.status();
  return attention::ParseColorModel(*text, name_or_file);
}

}  // namespace geon::cli
