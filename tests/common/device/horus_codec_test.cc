#include "device/horus_codec.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "base/contracts.h"

namespace geon::device {
namespace {

using HorusKind = HorusLine::Kind;

std::vector<HorusLine> HorusLines(HorusReader* reader, const std::string& bytes) {
  reader->Push(bytes);
  std::vector<HorusLine> lines;
  while (const auto line = reader->Next()) lines.push_back(*line);
  return lines;
}

TEST(HorusCodecTest, CommandsAreOneToALine) {
  EXPECT_EQ(EncodeLaserOn(1), "M71T1\r\n");
  EXPECT_EQ(EncodeLaserOff(2), "M70T2\r\n");
  EXPECT_THROW(EncodeLaserOn(3), ContractViolation);  // the board would answer "ok" and do nothing
}

TEST(HorusCodecTest, SortsWhatTheBoardSays) {
  HorusReader reader;
  const auto lines =
      HorusLines(&reader,
                 "\r\nHorus 0.2 ['$' for help]\r\nok\r\nerror: Unsupported command\r\n"
                 "ALARM: x\r\n[Caution]\r\n<Idle,MPos:0.000>\r\nHorus 0.1\r\nok?\r\n\xff\n");
  ASSERT_EQ(lines.size(), 9u);
  const std::vector<HorusKind> kinds = {
      HorusKind::kBanner,        HorusKind::kOk,      HorusKind::kError,
      HorusKind::kError,         HorusKind::kNote,    HorusKind::kNote,
      HorusKind::kForeignBanner, HorusKind::kUnknown, HorusKind::kUnknown};
  for (size_t i = 0; i < kinds.size(); ++i) EXPECT_EQ(lines[i].kind, kinds[i]) << lines[i].text;
}

TEST(HorusCodecTest, ALineMayComeInPieces) {
  HorusReader reader;
  EXPECT_TRUE(HorusLines(&reader, "o").empty());
  EXPECT_TRUE(HorusLines(&reader, "k").empty());
  const auto lines = HorusLines(&reader, "\r");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].kind, HorusKind::kOk);
  EXPECT_TRUE(HorusLines(&reader, "\n").empty());
}

TEST(HorusCodecTest, AnyBytesAreFollowedByStep) {
  std::mt19937 random(2);
  for (int i = 0; i < 10'000; ++i) {
    HorusReader reader;
    std::string noise(random() % 300, '\0');
    for (char& byte : noise) byte = static_cast<char>(random());
    HorusLines(&reader, noise + "\r\n");
    const auto lines = HorusLines(&reader, "ok\r\n");
    ASSERT_EQ(lines.size(), 1u);
    ASSERT_EQ(lines[0].kind, HorusKind::kOk);
  }
}

}  // namespace
}  // namespace geon::device
