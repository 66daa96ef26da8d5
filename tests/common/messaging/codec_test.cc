#include "messaging/codec.h"

#include <gtest/gtest.h>

#include <random>

#include "messaging/message_schema.h"
#include "sensor/laser_state.h"
#include "tests/common/messaging/sample_messages.h"

namespace geon::messaging {
namespace {

TEST(Codec, EveryMessageBeginsWithUtimeAndSeq) {
  const auto head = ReadMessageHead(Encode(samples::PtuState()));
  ASSERT_TRUE(head.has_value());
  EXPECT_EQ(head->fingerprint, WireFingerprint<sensor::PtuState>());
  EXPECT_EQ(head->utime, 12);
  EXPECT_EQ(head->seq, 3);
  EXPECT_FALSE(ReadMessageHead(std::vector<uint8_t>(19)).has_value());
}

TEST(Codec, AForeignTypeIsNamed) {
  const auto got = Decode<sensor::Image>(Encode(samples::PtuState()));
  EXPECT_EQ(got.message(), "expected geon.image_t, found geon.ptu_state_t");
  std::vector<uint8_t> unknown = Encode(samples::PtuState());
  unknown[7] ^= 1;
  EXPECT_NE(Decode<sensor::PtuState>(unknown).message().find("unknown type (fingerprint 0x"),
            std::string::npos);
}

// Where a count stands in the bytes of an image without data: 8 fingerprint + 8 + 5 * 4 + 4.
constexpr size_t kImageSizeAt = 36;

TEST(Codec, HostileCountsAreRefusedBeforeAnythingIsAllocated) {
  const std::vector<uint8_t> good = Encode(samples::GreyImage(5, 3));
  for (const uint32_t count : {0xffffffffu, 0x80000000u, 0x7fffffffu, 16u, 14u}) {
    std::vector<uint8_t> bytes = good;
    for (size_t i = 0; i < 4; ++i) {
      bytes[kImageSizeAt + i] = static_cast<uint8_t>(count >> (24 - 8 * i));
    }
    EXPECT_FALSE(Decode<sensor::Image>(bytes).ok()) << count;
  }
}

TEST(Codec, EveryTruncationIsRefused) {
  const std::vector<uint8_t> bytes = Encode(samples::Verdict());
  for (size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(Decode<sensor::GeonVerdict>(std::span(bytes).first(size)).ok()) << size;
  }
  EXPECT_TRUE(Decode<sensor::GeonVerdict>(bytes).ok());
}

TEST(Codec, BytesTooManyAreRefused) {
  std::vector<uint8_t> bytes = Encode(samples::Session());
  bytes.push_back(0);
  EXPECT_FALSE(Decode<sensor::Session>(bytes).ok());
}

template <typename T>
void FlipBits(const T& value, std::mt19937* random) {
  const std::vector<uint8_t> good = Encode(value);
  for (int round = 0; round < 500; ++round) {
    std::vector<uint8_t> bytes = good;
    for (int flip = 0; flip < 3; ++flip) {
      bytes[8 + (*random)() % (bytes.size() - 8)] ^= static_cast<uint8_t>(1u << (*random)() % 8);
    }
    const Result<T> got = Decode<T>(bytes);  // must return, whatever it says
    if (!got.ok()) {
      EXPECT_FALSE(got.message().empty());
    }
  }
}

TEST(Codec, FlippedBitsAreDecodedOrRefusedNeverThrown) {
  std::mt19937 random(1);
  FlipBits(samples::GreyImage(5, 3), &random);
  FlipBits(samples::Stripe(), &random);
  FlipBits(samples::ScanPlan(), &random);
  FlipBits(samples::TargetMask(), &random);
  FlipBits(samples::RangeProfile(), &random);
  FlipBits(samples::Verdict(), &random);
  FlipBits(samples::PlannerState(), &random);
  FlipBits(samples::TargetView(), &random);
  FlipBits(samples::Health(), &random);
  FlipBits(samples::Session(), &random);
}

}  // namespace
}  // namespace geon::messaging
