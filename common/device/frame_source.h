#pragma once

#include <memory>
#include <optional>
#include <string>

#include "base/status.h"
#include "device/v4l2_controls.h"
#include "sensor/image.h"

namespace geon::device {

struct FrameSourceOptions {
  // sim:ipc:///abs/path.frames | v4l2:/dev/video0 | images:DIR/f_%05d.png | video:FILE |
  // gst:PIPELINE
  std::string source;
  sensor::PixelFormat format = sensor::PixelFormat::kBgr8;  // kBgr8 or kGray8: what Poll delivers
  int width_px = 640;                                       // frames of another size are refused
  int height_px = 480;
  CameraControls controls;  // v4l2 only
  // Frames are stamped at the end of their exposure or later: by how much later at most, beyond the
  // exposure itself. Matters where frames must have begun after an event (lasers).
  double stamp_delay_s = 0.0;      // v4l2, stamped by the driver
  double unstamped_delay_s = 0.1;  // gst, or a driver that stamps nothing usable
  double file_rate_hz = 10.0;      // images and video: paced, from the start again at the end
  double timeout_s = 2.0;          // no fresh frame for so long: the source is reopened
  double first_retry_s = 0.2;      // doubles up to
  double longest_retry_s = 5.0;
};

// Frames from a camera, as they come: always the newest, never blocking. `seq` counts the source's
// frames, `utime` is the start of the exposure (for real cameras a safe bound: not later than it
// was).
//
// Watch file_descriptor() and call Poll() when it is readable, and a few times a second besides:
// that is when time-outs are noticed and a lost source is reopened.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  virtual int file_descriptor() const = 0;
  // The newest frame since the last call, or nothing yet. Error: the source delivers nothing and
  // why; it is being reopened, go on polling.
  virtual Result<std::optional<sensor::Image>> Poll(double time_s) = 0;
  virtual int reconnects() const = 0;
  // Asks for frames taken with another exposure; some taken before may still come. What the camera
  // really takes is said by the frames (v4l2: as last read back, so that the first frames after a
  // change may say it too early). Error: this kind of source cannot change it.
  virtual Status SetExposure(double exposure_s) = 0;
  // Controls that the camera refuses while it delivers frames all the same; empty: none.
  virtual std::string refused() const { return {}; }
};

// Errors: a source text that is none. A device that is not there is not one: it may come.
Result<std::unique_ptr<FrameSource>> OpenFrameSource(const FrameSourceOptions& options);

}  // namespace geon::device
