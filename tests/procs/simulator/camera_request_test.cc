#include "procs/simulator/camera_request.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace geon::simulator {
namespace {

Result<double> Parse(const std::string& text) {
  return ParseExposureRequest({reinterpret_cast<const uint8_t*>(text.data()), text.size()});
}

TEST(CameraRequest, AnExposureIsRead) {
  EXPECT_DOUBLE_EQ(Parse(R"({"exposure_us":8000})").value(), 0.008);
  EXPECT_DOUBLE_EQ(Parse(R"( {"exposure_us": 1, "gain": 2} )").value(), 1e-6);
}

TEST(CameraRequest, WhatIsNoRequestIsRefusedWithTheReason) {
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("null"), std::string("[8000]"),
        std::string("{}"), std::string(R"({"exposure_us":"8000"})"),
        std::string(R"({"exposure_us":8000.5})"), std::string(R"({"exposure_us":0})"),
        std::string(R"({"exposure_us":-1})"), std::string(R"({"exposure_us":10000001})"),
        std::string(R"({"exposure_us":18446744073709551615})"),
        std::string(R"({"exposure_us":1e400})"), std::string(256, '[') + "8000",
        R"({"exposure_us":8000})" + std::string(1000, ' ')}) {
    const auto exposure_s = Parse(text);
    EXPECT_FALSE(exposure_s.ok()) << text;
    EXPECT_NE(exposure_s.message().find("a request"), std::string::npos) << text;
  }
}

TEST(CameraRequest, AnyBytesAreRefusedOrWithinReason) {
  std::mt19937 random(1);
  const std::string good = R"({"exposure_us":8000})";
  for (int trial = 0; trial < 20000; ++trial) {
    std::string text = good;
    for (int k = 0; k < 3; ++k) text[random() % text.size()] = static_cast<char>(random() % 256);
    if (trial % 2 == 0) {
      text.resize(random() % 300);
      for (char& byte : text) byte = static_cast<char>(random() % 256);
    }
    const auto exposure_s = Parse(text);
    if (exposure_s.ok()) {
      EXPECT_TRUE(*exposure_s >= 1e-6 && *exposure_s <= 10.0) << text;
    }
  }
}

}  // namespace
}  // namespace geon::simulator
