#include "procs/geon/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "config/text_file.h"

namespace geon::cli {
namespace {

using testing::HasSubstr;

class ImageFileTest : public testing::Test {
 protected:
  void SetUp() override {
    dir_ =
        std::filesystem::temp_directory_path() / ("geon_image_file_" + std::to_string(::getpid()));
    std::filesystem::create_directories(dir_);
    picture_ = cv::Mat(24, 32, CV_8UC3, cv::Scalar(10, 20, 200));
  }
  void TearDown() override { std::filesystem::remove_all(dir_); }
  std::filesystem::path dir_;
  cv::Mat picture_;
};

TEST_F(ImageFileTest, PictureIsReadAsBlueGreenRed) {
  cv::imwrite((dir_ / "picture.png").string(), picture_);
  const auto image = LoadImage(dir_ / "picture.png");
  ASSERT_TRUE(image.ok()) << image.message();
  EXPECT_EQ(image->width_px, 32);
  EXPECT_EQ(image->height_px, 24);
  EXPECT_EQ(image->format, sensor::PixelFormat::kBgr8);
  EXPECT_EQ(image->data[0], 10);
  EXPECT_EQ(image->data[2], 200);
}

TEST_F(ImageFileTest, MissingForeignEmptyAndTruncatedFilesAreToldApart) {
  EXPECT_THAT(LoadImage(dir_ / "none.png").message(), HasSubstr("No such file"));
  ASSERT_TRUE(config::WriteFileAtomically(dir_ / "empty.png", "").ok());
  EXPECT_THAT(LoadImage(dir_ / "empty.png").message(), HasSubstr("is empty"));
  ASSERT_TRUE(config::WriteFileAtomically(dir_ / "text.png", "hello").ok());
  EXPECT_THAT(LoadImage(dir_ / "text.png").message(), HasSubstr("is no image"));
  cv::imwrite((dir_ / "whole.jpg").string(), picture_);
  const std::string bytes = config::ReadFile(dir_ / "whole.jpg").value();
  ASSERT_TRUE(
      config::WriteFileAtomically(dir_ / "cut.jpg", bytes.substr(0, bytes.size() / 2)).ok());
  EXPECT_THAT(LoadImage(dir_ / "cut.jpg").message(), HasSubstr("truncated JPEG"));
}

TEST_F(ImageFileTest, MaskMustHaveThePicturesSize) {
  std::vector<uint8_t> mask(32 * 24, 0);
  mask[5] = 255;
  ASSERT_TRUE(SaveGrayPng(dir_ / "mask.png", mask, 32, 24).ok());
  EXPECT_EQ(LoadMask(dir_ / "mask.png", 32, 24).value(), mask);
  EXPECT_THAT(LoadMask(dir_ / "mask.png", 32, 25).message(), HasSubstr("its picture 32 x 25"));
}

TEST_F(ImageFileTest, ColorModelIsANameOrAFile) {
  EXPECT_EQ(LoadColorModel("thesis-lab")->name, "thesis-lab");
  ASSERT_TRUE(
      config::WriteFileAtomically(
          dir_ / "green.yaml",
          "format: geon.color_model.v1\nname: green\nregion: target\nhalf_space: [-1, 1, -1, 20]\n")
          .ok());
  EXPECT_EQ(LoadColorModel((dir_ / "green.yaml").string())->name, "green");
  EXPECT_THAT(LoadColorModel("mauve").message(), HasSubstr("colours: super-red"));
}

}  // namespace
}  // namespace geon::cli
