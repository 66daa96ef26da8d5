#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "sensor/image.h"

namespace geon {

// Tests on real material skip themselves, saying so, where it is absent.
class RealDataTest : public testing::Test {
 protected:
  void SetUp() override {
    const char* named = std::getenv("GEON_DATA");
    root_ = named != nullptr ? std::filesystem::path(named)
                             : std::filesystem::path(GEON_SOURCE_DIR) / "../shared/data";
    if (!std::filesystem::exists(root_ / "README.md")) {
      GTEST_SKIP() << "no real data at " << root_ << "; name its folder by GEON_DATA";
    }
  }
  sensor::Image Load(const std::string& relative) const {
    const cv::Mat pixels =
        cv::imread((root_ / relative).string(), cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
    EXPECT_FALSE(pixels.empty()) << relative;
    sensor::Image image;
    image.width_px = pixels.cols;
    image.height_px = pixels.rows;
    image.row_stride_bytes = 3 * pixels.cols;
    image.format = sensor::PixelFormat::kBgr8;
    image.data.assign(pixels.data, pixels.data + pixels.total() * 3);
    return image;
  }
  // One channel of an image, as a mask.
  std::vector<uint8_t> LoadMask(const std::string& relative) const {
    const sensor::Image image = Load(relative);
    std::vector<uint8_t> mask;
    for (size_t i = 0; i < image.data.size(); i += 3) mask.push_back(image.data[i]);
    return mask;
  }
  // The lines of a CSV file without quoted commas, header left out.
  std::vector<std::vector<std::string>> ReadCsv(const std::string& relative) const {
    std::ifstream file(root_ / relative);
    std::string line;
    std::getline(file, line);
    std::vector<std::vector<std::string>> rows;
    while (std::getline(file, line)) {
      rows.emplace_back();
      std::istringstream fields(line);
      std::string field;
      while (std::getline(fields, field, ',')) rows.back().push_back(field);
    }
    return rows;
  }
  // Files of a folder, by name.
  std::vector<std::string> Files(const std::string& folder) const {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(root_ / folder)) {
      files.push_back(folder + "/" + entry.path().filename().string());
    }
    std::sort(files.begin(), files.end());
    return files;
  }

 private:
  std::filesystem::path root_;
};

}  // namespace geon
