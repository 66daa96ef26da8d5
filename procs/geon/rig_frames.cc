#include "procs/geon/rig_frames.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>

#include "base/angles.h"
#include "calibration/find_board.h"
#include "config/text_file.h"
#include "procs/geon/csv_table.h"
#include "procs/geon/image_file.h"
#include "rangefinder/laser_light.h"

namespace geon::cli {
namespace {

using Camera = RigFrame::Camera;
using Light = RigFrame::Light;
using sensor::Laser;

const std::vector<std::string> kHeading = {"stop",  "pan_deg",    "tilt_deg", "camera",
                                           "laser", "exposure_s", "file"};

const char* NameOf(Camera camera) { return camera == Camera::kColor ? "color" : "stripe"; }
const char* NameOf(Light light) {
  if (light == Light::kNone) return "none";
  return light == Light::kHorizontal ? "horizontal" : "vertical";
}
Laser LaserOf(Light light) {
  return light == Light::kVertical ? Laser::kVertical : Laser::kHorizontal;
}

std::optional<double> NumberIn(const std::string& text, double low, double high) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (!(number >= low && number <= high)) return std::nullopt;
  return number;
}

// One line of the listing: the shot it belongs to, without pictures, and its frame.
Result<RigShot> ReadLine(const CsvTable& table, size_t row) {
  if (table.rows[row].size() != kHeading.size()) {
    return Status::Error("must have " + std::to_string(kHeading.size()) + " fields");
  }
  const auto field = [&](const char* column) { return table.At(row, column); };
  RigShot shot;
  if (field("stop") == "floor") {
    shot.stop = RigShot::kFloor;
  } else {
    const auto stop = NumberIn(field("stop"), 0, 1000);
    if (!stop || *stop != std::floor(*stop)) return Status::Error("stop must be 0..1000 or floor");
    shot.stop = static_cast<int>(*stop);
  }
  const auto pan_deg = NumberIn(field("pan_deg"), -180, 180);
  const auto tilt_deg = NumberIn(field("tilt_deg"), -90, 90);
  if (!pan_deg || !tilt_deg) return Status::Error("pan_deg and tilt_deg must be degrees");
  shot.pan_rad = RadiansFromDegrees(*pan_deg);
  shot.tilt_rad = RadiansFromDegrees(*tilt_deg);

  RigFrame frame;
  if (field("camera") != "color" && field("camera") != "stripe") {
    return Status::Error("camera must be color or stripe");
  }
  frame.camera = field("camera") == "color" ? Camera::kColor : Camera::kStripe;
  if (field("laser") == "horizontal") {
    frame.light = Light::kHorizontal;
  } else if (field("laser") == "vertical") {
    frame.light = Light::kVertical;
  } else if (field("laser") != "none") {
    return Status::Error("laser must be none, horizontal or vertical");
  }
  const auto exposure_s = NumberIn(field("exposure_s"), 1e-6, 60);
  if (!exposure_s) return Status::Error("exposure_s must be seconds");
  frame.exposure_s = *exposure_s;
  frame.file = field("file");
  if (frame.file.empty()) return Status::Error("file is missing");
  shot.frames.push_back(frame);
  return shot;
}

const RigFrame* LongestUnlit(const RigShot& shot, Camera camera) {
  const RigFrame* longest = nullptr;
  for (const RigFrame& frame : shot.frames) {
    if (frame.camera != camera || frame.light != Light::kNone) continue;
    if (longest == nullptr || frame.exposure_s > longest->exposure_s) longest = &frame;
  }
  return longest;
}

// The laser's light alone, of the frame in which it burned.
std::optional<sensor::Image> LightOf(const RigShot& shot, Light light) {
  for (const RigFrame& lit : shot.frames) {
    if (lit.camera != Camera::kStripe || lit.light != light) continue;
    for (const RigFrame& dark : shot.frames) {
      if (dark.camera == Camera::kStripe && dark.light == Light::kNone &&
          dark.exposure_s == lit.exposure_s) {
        return rangefinder::LaserLight(lit.image, dark.image, rangefinder::LaserColor::kMono);
      }
    }
    return rangefinder::LaserLight(lit.image, rangefinder::LaserColor::kMono);
  }
  return std::nullopt;
}

Status CheckSize(const RigFrame& frame, const geometry::SensorRig& drawn) {
  const geometry::PinholeCamera& camera =
      frame.camera == Camera::kColor ? drawn.color_camera : drawn.stripe_camera;
  if (frame.image.width_px == camera.width_px && frame.image.height_px == camera.height_px) {
    return Status::Ok();
  }
  return Status::Error(frame.file + ": is " + std::to_string(frame.image.width_px) + " x " +
                       std::to_string(frame.image.height_px) + ", the drawing's " +
                       NameOf(frame.camera) + " camera takes " + std::to_string(camera.width_px) +
                       " x " + std::to_string(camera.height_px));
}

std::string DegreesOf(double angle_rad) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.6f", DegreesFromRadians(angle_rad));
  return text;
}

Status SavePicture(const std::filesystem::path& file, const sensor::Image& image) {
  const int type = sensor::ChannelCount(image.format) == 1 ? CV_8UC1 : CV_8UC3;
  const cv::Mat pixels(image.height_px, image.width_px, type,
                       const_cast<uint8_t*>(image.data.data()),
                       static_cast<size_t>(image.row_stride_bytes));
  std::vector<uint8_t> bytes;
  cv::imencode(".png", pixels, bytes);
  return config::WriteFileAtomically(file, std::string(bytes.begin(), bytes.end()));
}

}  // namespace

Result<RigSeries> RecordedRig(const std::filesystem::path& directory) {
  const std::filesystem::path listing = directory / "frames.csv";
  const Result<std::string> text = config::ReadFile(listing, 16U << 20U);
  if (!text.ok()) return text.status();
  const CsvTable table = ParseCsv(*text);
  if (table.heading != kHeading) {
    return Status::Error(
        listing.string() +
        ":1: the header must be stop,pan_deg,tilt_deg,camera,laser,exposure_s,file");
  }
  std::vector<RigShot> shots;
  for (size_t row = 0; row < table.rows.size(); ++row) {
    Result<RigShot> line = ReadLine(table, row);
    if (!line.ok()) return line.status().In(listing.string() + ":" + std::to_string(row + 2));
    const auto same = std::find_if(shots.begin(), shots.end(), [&](const RigShot& shot) {
      return shot.stop == line->stop && shot.pan_rad == line->pan_rad &&
             shot.tilt_rad == line->tilt_rad;
    });
    if (same == shots.end()) {
      shots.push_back(*std::move(line));
    } else {
      same->frames.push_back(line->frames.front());
    }
  }
  if (shots.empty()) return Status::Error(listing.string() + ": lists no frames");
  RigSeries series;
  series.shots = static_cast<int>(shots.size());
  series.at = [directory, shots](int k) -> Result<RigShot> {
    RigShot shot = shots[static_cast<size_t>(k)];
    for (RigFrame& frame : shot.frames) {
      frame.file = (directory / frame.file).string();
      Result<sensor::Image> image = LoadImage(frame.file);
      if (!image.ok()) return image.status();
      frame.image = *std::move(image);
    }
    return shot;
  };
  return series;
}

Result<RigRecorder> RigRecorder::Create(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) return Status::Error(directory.string() + ": cannot create: " + error.message());
  RigRecorder recorder;
  recorder.directory_ = directory;
  for (const std::string& column : kHeading) {
    recorder.listing_ += (recorder.listing_.empty() ? "" : ",") + column;
  }
  recorder.listing_ += "\n";
  return recorder;
}

Status RigRecorder::Add(const RigShot& shot) {
  char number[16];
  std::snprintf(number, sizeof(number), "%04d", shots_++);
  for (const RigFrame& frame : shot.frames) {
    char exposure[32];
    std::snprintf(exposure, sizeof(exposure), "%g", frame.exposure_s);
    const std::string file = std::string(number) + "_" + NameOf(frame.camera) + "_" +
                             NameOf(frame.light) + "_" + exposure + ".png";
    const Status saved = SavePicture(directory_ / file, frame.image);
    if (!saved.ok()) return saved;
    listing_ += (shot.stop == RigShot::kFloor ? "floor" : std::to_string(shot.stop)) + "," +
                DegreesOf(shot.pan_rad) + "," + DegreesOf(shot.tilt_rad) + "," +
                NameOf(frame.camera) + "," + NameOf(frame.light) + "," + exposure + "," + file +
                "\n";
  }
  return Status::Ok();
}

Status RigRecorder::Finish() const {
  return config::WriteFileAtomically(directory_ / "frames.csv", listing_);
}

Status ObserveShot(const RigShot& shot, const geometry::SensorRig& drawn,
                   calibration::RigObservations* observations) {
  for (const RigFrame& frame : shot.frames) {
    const Status size = CheckSize(frame, drawn);
    if (!size.ok()) return size;
  }
  if (shot.stop == RigShot::kFloor) {
    const auto light = LightOf(shot, Light::kHorizontal);
    if (light) {
      observations->floor.push_back(
          {shot.pan_rad, shot.tilt_rad, calibration::StripePoints(*light, Laser::kHorizontal)});
    }
    return Status::Ok();
  }
  const calibration::Chessboard& board = observations->board;
  calibration::BoardView view{shot.stop, shot.pan_rad, shot.tilt_rad, {}, {}, {}, {}};
  if (const RigFrame* color = LongestUnlit(shot, Camera::kColor)) {
    const auto sighting = calibration::FindBoard(color->image, board);
    if (sighting) view.color_corners_px = sighting->corners_px;
  }
  const RigFrame* unlit = LongestUnlit(shot, Camera::kStripe);
  const auto sighting =
      unlit == nullptr ? std::nullopt : calibration::FindBoard(unlit->image, board);
  if (sighting) {
    view.stripe_corners_px = sighting->corners_px;
    for (const Light light : {Light::kHorizontal, Light::kVertical}) {
      const auto laser_light = LightOf(shot, light);
      if (!laser_light) continue;
      calibration::BoardStripe stripe =
          calibration::FindStripeOnBoard(*laser_light, LaserOf(light), board, *sighting);
      if (stripe.other_way) {
        return Status::Error(
            std::string("the lasers are swapped: at stop ") + std::to_string(shot.stop) + ", pan " +
            DegreesOf(shot.pan_rad) + ", the frame said to show the " + NameOf(light) +
            " stripe shows the other; exchange their plugs, or the names in frames.csv");
      }
      (light == Light::kHorizontal ? view.horizontal_px : view.vertical_px) =
          std::move(stripe.points_px);
    }
  }
  observations->views.push_back(std::move(view));
  return Status::Ok();
}

}  // namespace geon::cli
