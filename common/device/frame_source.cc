#include "device/frame_source.h"

#include "base/contracts.h"
#include "device/capture_frame_source.h"
#include "device/socket_frame_source.h"

namespace geon::device {

Result<std::unique_ptr<FrameSource>> OpenFrameSource(const FrameSourceOptions& options) {
  Require(
      options.format == sensor::PixelFormat::kBgr8 || options.format == sensor::PixelFormat::kGray8,
      "a frame source delivers bgr8 or gray8");
  using Kind = CaptureFrameSource::Kind;
  const size_t colon = options.source.find(':');
  const std::string kind = options.source.substr(0, colon);
  const std::string target =
      colon == std::string::npos ? std::string() : options.source.substr(colon + 1);
  const auto capture = [&](Kind capture_kind) -> std::unique_ptr<FrameSource> {
    return std::make_unique<CaptureFrameSource>(capture_kind, target, options);
  };
  if (!target.empty()) {
    if (kind == "v4l2") return capture(Kind::kV4l2);
    if (kind == "images") return capture(Kind::kImages);
    if (kind == "video") return capture(Kind::kVideo);
    if (kind == "gst") return capture(Kind::kGStreamer);
    const bool endpoint = target.rfind("ipc://", 0) == 0 || target.rfind("tcp://", 0) == 0;
    if (kind == "sim" && endpoint) {
      return std::unique_ptr<FrameSource>(std::make_unique<SocketFrameSource>(target, options));
    }
  }
  return Status::Error("\"" + options.source +
                       "\" is no frame source: sim:ipc:///PATH, v4l2:/dev/videoN, "
                       "images:DIR/f_%05d.png, video:FILE or gst:PIPELINE");
}

}  // namespace geon::device
