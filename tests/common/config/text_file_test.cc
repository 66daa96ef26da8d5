#include "config/text_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace geon::config {
namespace {

using testing::HasSubstr;

class TextFileTest : public testing::Test {
 protected:
  void SetUp() override {
    dir_ =
        std::filesystem::temp_directory_path() / ("geon_text_file_" + std::to_string(::getpid()));
    std::filesystem::create_directories(dir_);
  }
  void TearDown() override { std::filesystem::remove_all(dir_); }
  std::filesystem::path dir_;
};

TEST_F(TextFileTest, BytesComeBackAsWritten) {
  const std::string bytes("a\0b\n\xff", 5);
  ASSERT_TRUE(WriteFileAtomically(dir_ / "file", bytes).ok());
  EXPECT_EQ(ReadFile(dir_ / "file").value(), bytes);
  ASSERT_TRUE(WriteFileAtomically(dir_ / "file", "new").ok());
  EXPECT_EQ(ReadFile(dir_ / "file").value(), "new");
}

TEST_F(TextFileTest, NothingButTheFileIsLeftBehind) {
  ASSERT_TRUE(WriteFileAtomically(dir_ / "file", "x").ok());
  const auto entries = std::distance(std::filesystem::directory_iterator(dir_), {});
  EXPECT_EQ(entries, 1);
}

TEST_F(TextFileTest, FileLargerThanAllowedIsAnError) {
  ASSERT_TRUE(WriteFileAtomically(dir_ / "file", std::string(200000, 'x')).ok());
  EXPECT_EQ(ReadFile(dir_ / "file", 200000)->size(), 200000U);
  EXPECT_THAT(ReadFile(dir_ / "file", 199999).message(), HasSubstr("larger than the 199999 bytes"));
}

TEST_F(TextFileTest, ErrorsNameTheFileAndTheReason) {
  EXPECT_THAT(ReadFile(dir_ / "none").message(), HasSubstr("No such file"));
  EXPECT_THAT(ReadFile(dir_).message(), HasSubstr("is a directory"));
  EXPECT_THAT(WriteFileAtomically(dir_ / "no" / "file", "x").message(), HasSubstr("cannot write"));
  ASSERT_TRUE(std::filesystem::create_directory(dir_ / "taken"));
  EXPECT_THAT(WriteFileAtomically(dir_ / "taken", "x").message(), HasSubstr("cannot replace"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(dir_), {}), 1);
}

}  // namespace
}  // namespace geon::config
