#include <charconv>
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "attention/color_model_text.h"
#include "attention/learn_color_model.h"
#include "base/angles.h"
#include "config/text_file.h"
#include "procs/geon/commands.h"
#include "procs/geon/image_file.h"

namespace geon::cli {
namespace {

using Json = nlohmann::ordered_json;

struct TeachArguments {
  std::vector<std::string> images;
  std::vector<std::string> boxes;
  std::vector<std::string> masks;
  std::string name;
  std::string output;
  bool json = false;
};

// "x,y,w,h" in pixels.
std::optional<sensor::PixelBox> ParseBox(const std::string& text) {
  int numbers[4] = {};
  const char* next = text.data();
  const char* const end = text.data() + text.size();
  for (int i = 0; i < 4; ++i) {
    const auto [stop, error] = std::from_chars(next, end, numbers[i]);
    if (error != std::errc() || (i < 3 && (stop == end || *stop != ',')) ||
        (i == 3 && stop != end)) {
      return std::nullopt;
    }
    next = stop + 1;
  }
  const sensor::PixelBox box{numbers[0], numbers[1], numbers[2], numbers[3]};
  if (box.w_px <= 0 || box.h_px <= 0) return std::nullopt;
  return box;
}

// The part of a box that lies in the picture.
Result<std::vector<uint8_t>> MaskOfBox(const std::string& text, const sensor::Image& image) {
  const auto box = ParseBox(text);
  if (!box) return Status::Error("--box " + text + ": expected x,y,w,h in pixels");
  std::vector<uint8_t> mask(
      static_cast<size_t>(image.width_px) * static_cast<size_t>(image.height_px), 0);
  bool any = false;
  for (int v = std::max(0, box->v_px); v < std::min(image.height_px, box->v_px + box->h_px); ++v) {
    for (int u = std::max(0, box->u_px); u < std::min(image.width_px, box->u_px + box->w_px); ++u) {
      mask[static_cast<size_t>(v) * static_cast<size_t>(image.width_px) + static_cast<size_t>(u)] =
          255;
      any = true;
    }
  }
  if (!any) return Status::Error("--box " + text + ": lies outside the picture");
  return mask;
}

Result<std::vector<attention::TeachingSample>> LoadSamples(const TeachArguments& arguments) {
  const auto& regions = arguments.boxes.empty() ? arguments.masks : arguments.boxes;
  if (regions.size() != 1 && regions.size() != arguments.images.size()) {
    return Status::Error("give one --box or --mask for all images, or one for each");
  }
  std::vector<attention::TeachingSample> samples;
  for (size_t i = 0; i < arguments.images.size(); ++i) {
    Result<sensor::Image> image = LoadImage(arguments.images[i]);
    if (!image.ok()) return image.status();
    const std::string& region = regions.size() == 1 ? regions[0] : regions[i];
    Result<std::vector<uint8_t>> mask = arguments.boxes.empty()
                                            ? LoadMask(region, image->width_px, image->height_px)
                                            : MaskOfBox(region, *image);
    if (!mask.ok()) return mask.status();
    samples.push_back({*std::move(image), *std::move(mask)});
  }
  return samples;
}

Json ToJson(const std::string& output, const attention::LearnedColor& learned) {
  const attention::TeachingReport& report = learned.report;
  return {{"file", output},
          {"name", learned.model.name},
          {"target_pixels", report.target_pixels},
          {"background_pixels", report.background_pixels},
          {"recall", report.recall_1},
          {"precision", report.precision_1},
          {"clipped", report.clipped_fraction_1},
          {"hue_deg", DegreesFromRadians(report.mean_color.hue_rad)},
          {"saturation", report.mean_color.saturation_1},
          {"intensity", report.mean_color.intensity_1},
          {"warnings", report.warnings}};
}

void Tell(const std::string& output, const attention::LearnedColor& learned) {
  const attention::TeachingReport& report = learned.report;
  const auto percent = [](double share) { return std::lround(100.0 * share); };
  std::cout << output << ": colour " << learned.model.name << ", hue "
            << std::lround(DegreesFromRadians(report.mean_color.hue_rad)) << " degrees, saturation "
            << percent(report.mean_color.saturation_1) << " %, intensity "
            << std::lround(report.mean_color.intensity_1) << "\n"
            << "learned from " << report.target_pixels << " target and " << report.background_pixels
            << " other pixels: takes " << percent(report.recall_1) << " % of the target, "
            << percent(report.precision_1) << " % of what it takes is target\n";
}

int Teach(const TeachArguments& arguments) {
  const auto fail = [](const std::string& message) {
    std::cerr << "geon teach: " << message << "\n";
    return kFailed;
  };
  const Result<std::vector<attention::TeachingSample>> samples = LoadSamples(arguments);
  if (!samples.ok()) return fail(samples.message());
  const std::string name = arguments.name.empty()
                               ? std::filesystem::path(arguments.output).stem().string()
                               : arguments.name;
  if (name.find_first_of("#:\n") != std::string::npos) {
    return fail("--name " + name + ": must not hold # : or a line break");
  }
  const Result<attention::LearnedColor> learned = attention::LearnColorModel(*samples, name);
  if (!learned.ok()) return fail(learned.message());

  std::vector<std::string> comments = {"Colour model learned by geon teach from:"};
  for (const std::string& image : arguments.images) {
    comments.push_back("  " + std::filesystem::path(image).filename().string());
  }
  const Status written = config::WriteFileAtomically(
      arguments.output, attention::SerializeColorModel(learned->model, comments));
  if (!written.ok()) return fail(written.message());
  for (const std::string& warning : learned->report.warnings) {
    std::cerr << "geon teach: warning: " << warning << "\n";
  }
  if (arguments.json) {
    std::cout
        << ToJson(arguments.output, *learned).dump(-1, ' ', false, Json::error_handler_t::replace)
        << "\n";
  } else {
    Tell(arguments.output, *learned);
  }
  return kOk;
}

}  // namespace

void AddTeachCommand(CLI::App& app, int* exit_code) {
  auto arguments = std::make_shared<TeachArguments>();
  CLI::App* command =
      app.add_subcommand("teach",
                         "Learns the target's colour from pictures: the box or mask is the target, "
                         "everything else is not.");
  command->add_option("IMAGE", arguments->images, "Colour images")->required();
  CLI::Option* box = command->add_option("--box", arguments->boxes,
                                         "x,y,w,h of the target in pixels; once, or one an image");
  CLI::Option* mask = command->add_option("--mask", arguments->masks,
                                          "PNG, non-zero on the target; once, or one an image");
  for (CLI::Option* option : {box, mask}) option->expected(1)->take_all();
  box->excludes(mask);
  command->add_option("--name", arguments->name, "Name of the colour; default: that of the file");
  command->add_option("-o", arguments->output, "File to write, for geon segment --color FILE")
      ->required();
  command->add_flag("--json", arguments->json, "The report as one JSON object");
  command->callback([arguments, exit_code] {
    if (arguments->boxes.empty() && arguments->masks.empty()) {
      throw CLI::RequiredError("--box or --mask");
    }
    *exit_code = Teach(*arguments);
  });
}

}  // namespace geon::cli
