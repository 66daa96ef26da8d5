#include "procs/geon/board_frames.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <sstream>

#include "config/text_file.h"
#include "procs/geon/image_file.h"
#include "procs/lockstep/frame_image.h"
#include "sim/rig_renderer.h"

namespace geon::cli {
namespace {

using sensor::Laser;

struct ListedFrame {
  std::string lit;
  std::string unlit;
};
using ListedFrames = std::map<double, std::vector<ListedFrame>>;

Result<ListedFrames> ReadListing(const std::filesystem::path& file, Laser wanted) {
  const Result<std::string> text = config::ReadFile(file);
  if (!text.ok()) return text.status();
  std::istringstream lines(*text);
  std::string line;
  int number = 0;
  ListedFrames listed;
  while (std::getline(lines, line)) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const auto error = [&](const std::string& why) {
      return Status::Error(file.string() + ":" + std::to_string(number) + ": " + why);
    };
    if (number == 1) {
      if (line != "laser,distance_m,lit,unlit") {
        return error("the header must be laser,distance_m,lit,unlit");
      }
      continue;
    }
    if (line.empty()) continue;
    std::vector<std::string> fields(1);
    for (const char c : line) {
      if (c == ',') {
        fields.emplace_back();
      } else {
        fields.back().push_back(c);
      }
    }
    if (fields.size() != 4 || fields[2].empty())
      return error("expected laser,distance_m,lit,unlit");
    if (fields[0] != "horizontal" && fields[0] != "vertical") {
      return error("laser must be horizontal or vertical");
    }
    double distance_m = 0.0;
    const char* end = fields[1].data() + fields[1].size();
    const auto [stop, failure] = std::from_chars(fields[1].data(), end, distance_m);
    if (failure != std::errc() || stop != end || !(distance_m > 0.0) || !(distance_m < 100.0)) {
      return error("distance_m must be a number of metres");
    }
    if (fields[0] != ToString(wanted)) continue;
    listed[distance_m].push_back({fields[2], fields[3]});
  }
  if (listed.empty()) {
    return Status::Error(file.string() + ": lists no frames of the " +
                         std::string(ToString(wanted)) + " laser");
  }
  return listed;
}

Result<sensor::Image> LoadLight(const std::filesystem::path& directory, const ListedFrame& frame,
                                rangefinder::LaserColor color) {
  const Result<sensor::Image> lit = LoadImage(directory / frame.lit);
  if (!lit.ok()) return lit.status();
  if (frame.unlit.empty()) return rangefinder::LaserLight(*lit, color);
  const Result<sensor::Image> unlit = LoadImage(directory / frame.unlit);
  if (!unlit.ok()) return unlit.status();
  if (unlit->width_px != lit->width_px || unlit->height_px != lit->height_px) {
    return Status::Error((directory / frame.unlit).string() + ": differs in size from " +
                         frame.lit);
  }
  return rangefinder::LaserLight(*lit, *unlit, color);
}

}  // namespace

BoardSeries SimulatedBoard(const geometry::SensorRig& designed, const sim::RendererOptions& options,
                           uint64_t seed, Laser laser, const BoardSteps& steps) {
  const sim::RigPose pose;
  const auto renderer = std::make_shared<sim::RigRenderer>(
      sim::BoardScene(geometry::RigidTransform::Identity(), steps.from_m), designed, options, seed);
  const geometry::RigidTransform X_WB = renderer->StripeCameraPose(pose);
  sim::LaserFractions burning;
  (laser == Laser::kVertical ? burning.vertical_1 : burning.horizontal_1) = 1.0;

  BoardSeries series;
  series.distances =
      static_cast<int>(std::floor((steps.to_m - steps.from_m) / steps.step_m + 1e-6)) + 1;
  series.frames = steps.frames;
  series.at = [=](int k) -> Result<BoardFrames> {
    BoardFrames board;
    board.distance_m = steps.from_m + steps.step_m * k;
    renderer->SetScene(sim::BoardScene(X_WB, board.distance_m));
    for (int frame = 0; frame < steps.frames; ++frame) {
      const int64_t seq = 2 * (static_cast<int64_t>(k) * steps.frames + frame) +
                          (laser == Laser::kVertical ? 1'000'000 : 0);
      const auto lit = lockstep::ImageOf(renderer->HeadBw(pose, burning, seq));
      const auto unlit = lockstep::ImageOf(renderer->HeadBw(pose, {}, seq + 1));
      board.light.push_back(rangefinder::LaserLight(lit, unlit, rangefinder::LaserColor::kMono));
    }
    return board;
  };
  return series;
}

Result<BoardSeries> RecordedBoard(const std::filesystem::path& directory, Laser laser,
                                  rangefinder::LaserColor color) {
  Result<ListedFrames> listed = ReadListing(directory / "frames.csv", laser);
  if (!listed.ok()) return listed.status();
  const std::vector<std::pair<double, std::vector<ListedFrame>>> boards(listed->begin(),
                                                                        listed->end());
  BoardSeries series;
  series.distances = static_cast<int>(boards.size());
  const auto fewest = std::min_element(
      boards.begin(), boards.end(),
      [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
  series.frames = static_cast<int>(fewest->second.size());
  series.at = [directory, color, boards](int k) -> Result<BoardFrames> {
    const auto& [distance_m, frames] = boards[static_cast<size_t>(k)];
    BoardFrames board;
    board.distance_m = distance_m;
    for (const ListedFrame& frame : frames) {
      Result<sensor::Image> light = LoadLight(directory, frame, color);
      if (!light.ok()) return light.status();
      if (!board.light.empty() && (light->width_px != board.light[0].width_px ||
                                   light->height_px != board.light[0].height_px)) {
        return Status::Error((directory / frame.lit).string() +
                             ": differs in size from the frames before");
      }
      board.light.push_back(*std::move(light));
    }
    return board;
  };
  return series;
}

}  // namespace geon::cli
