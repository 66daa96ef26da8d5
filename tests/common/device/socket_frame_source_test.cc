#include "device/socket_frame_source.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>
#include <zmq.h>

#include <algorithm>
#include <string>
#include <vector>

namespace geon::device {
namespace {

// A simulator's end of a frame socket.
class Publisher {
 public:
  explicit Publisher(const std::string& endpoint)
      : context_(zmq_ctx_new()), socket_(zmq_socket(context_, ZMQ_XPUB)) {
    EXPECT_EQ(zmq_bind(socket_, endpoint.c_str()), 0) << endpoint;
  }
  ~Publisher() {
    const int no_linger = 0;
    zmq_setsockopt(socket_, ZMQ_LINGER, &no_linger, sizeof(no_linger));
    zmq_close(socket_);
    zmq_ctx_term(context_);
  }
  // Blocks until the source has subscribed.
  void WaitForSubscriber() {
    char subscription[16];
    EXPECT_GT(zmq_recv(socket_, subscription, sizeof(subscription), 0), 0);
  }
  // Blocks until the source has asked for something.
  std::string WaitForRequest() {
    char request[64];
    const int size = zmq_recv(socket_, request, sizeof(request), 0);
    return {request, static_cast<size_t>(std::max(0, size))};
  }
  void Send(int seq, int64_t utime, int width = 4, const std::string& format = "gray8") {
    const std::string header = "{\"seq\":" + std::to_string(seq) +
                               ",\"utime\":" + std::to_string(utime) +
                               ",\"width\":" + std::to_string(width) +
                               ",\"height\":2,\"format\":\"" + format + "\",\"exposure_us\":100}";
    SendParts({header, std::string(static_cast<size_t>(width) * 2, 'x')});
  }
  void SendParts(const std::vector<std::string>& parts) {
    for (size_t i = 0; i < parts.size(); ++i) {
      zmq_send(socket_, parts[i].data(), parts[i].size(), i + 1 < parts.size() ? ZMQ_SNDMORE : 0);
    }
  }

 private:
  void* context_;
  void* socket_;
};

class SocketFrameSourceTest : public testing::Test {
 protected:
  SocketFrameSourceTest() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    endpoint_ = "ipc:///tmp/geon_socket_frame_source_" + std::to_string(getpid()) + info->name();
    options_.format = sensor::PixelFormat::kGray8;
    options_.width_px = 4;
    options_.height_px = 2;
    publisher_ = std::make_unique<Publisher>(endpoint_);
    source_ = std::make_unique<SocketFrameSource>(endpoint_, options_);
    publisher_->WaitForSubscriber();
  }
  // Polls, all at virtual time 1, until something has come.
  Result<std::optional<sensor::Image>> PollUntilSomething() {
    for (int i = 0; i < 200; ++i) {
      auto frame = source_->Poll(1.0);
      if (!frame.ok() || frame->has_value()) return frame;
      pollfd fd{source_->file_descriptor(), POLLIN, 0};
      poll(&fd, 1, 50);
    }
    return Status::Error("nothing came");
  }

  std::string endpoint_;
  FrameSourceOptions options_;
  std::unique_ptr<Publisher> publisher_;
  std::unique_ptr<SocketFrameSource> source_;
};

TEST_F(SocketFrameSourceTest, DeliversAFrame) {
  publisher_->Send(3, 1000);
  const auto frame = PollUntilSomething();
  ASSERT_TRUE(frame.ok()) << frame.message();
  EXPECT_EQ((*frame)->seq, 3);
  EXPECT_EQ((*frame)->utime, 1000);
  EXPECT_EQ((*frame)->data.size(), 8u);
}

TEST_F(SocketFrameSourceTest, AsksForAnExposureAndFramesComeOn) {
  EXPECT_TRUE(source_->SetExposure(0.008).ok());
  EXPECT_TRUE(source_->SetExposure(0.0125).ok());  // before it was sent: the newest counts
  EXPECT_TRUE(source_->Poll(1.0).ok());
  EXPECT_EQ(publisher_->WaitForRequest(), "{\"exposure_us\":12500}");
  publisher_->Send(3, 1000);
  const auto frame = PollUntilSomething();
  ASSERT_TRUE(frame.ok()) << frame.message();
  EXPECT_DOUBLE_EQ((*frame)->exposure_s.value(), 0.0001) << "as the frame says";
  EXPECT_EQ(source_->refused(), "");
}

TEST_F(SocketFrameSourceTest, FramesThatRepeatOrDoNotFitAreRefused) {
  publisher_->Send(1, 1000);
  ASSERT_TRUE(PollUntilSomething().ok());
  publisher_->Send(2, 1000);
  EXPECT_NE(PollUntilSomething().message().find("repeat the stamp"), std::string::npos);
  publisher_->Send(3, 2000, 5);
  EXPECT_NE(PollUntilSomething().message().find("5x2, not 4x2"), std::string::npos);
  publisher_->SendParts({"{}", "pixels", "and more"});
  EXPECT_NE(PollUntilSomething().message().find("more than two parts"), std::string::npos);
  publisher_->SendParts({"alone"});
  EXPECT_NE(PollUntilSomething().message().find("one part"), std::string::npos);
  publisher_->SendParts({"no json", "x"});
  EXPECT_NE(PollUntilSomething().message().find("not a JSON object"), std::string::npos);
  publisher_->Send(4, 3000);
  EXPECT_TRUE(PollUntilSomething().ok());
}

TEST_F(SocketFrameSourceTest, SilenceIsAnErrorUntilFramesComeAgain) {
  EXPECT_TRUE(source_->Poll(1.0).ok());
  EXPECT_TRUE(source_->Poll(2.9).ok());
  const auto silent = source_->Poll(3.1);
  ASSERT_FALSE(silent.ok());
  EXPECT_NE(silent.message().find("no fresh frame"), std::string::npos);
  publisher_->Send(1, 5000);
  pollfd fd{source_->file_descriptor(), POLLIN, 0};
  Result<std::optional<sensor::Image>> frame = source_->Poll(3.2);
  for (int i = 0; i < 100 && !frame.ok(); ++i) {
    poll(&fd, 1, 50);
    frame = source_->Poll(3.2);
  }
  EXPECT_TRUE(frame.ok()) << frame.message();
  EXPECT_EQ(source_->reconnects(), 1);
}

}  // namespace
}  // namespace geon::device
