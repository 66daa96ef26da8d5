#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "attention/find_target.h"
#include "procs/geon/commands.h"
#include "procs/geon/image_file.h"

namespace geon::cli {
namespace {

using Json = nlohmann::ordered_json;

struct SegmentArguments {
  std::vector<std::string> images;
  std::string color = "super-red";
  std::string mask_dir;
  int erosion_neighbors = attention::AttentionOptions{}.erosion_neighbors;
  int min_pixels = attention::AttentionOptions{}.min_target_pixels;
  bool json = false;
};

Json ToJson(const std::string& file, const attention::TargetSighting& sighting) {
  Json line = {{"file", file}, {"target_box_px", nullptr}};
  if (sighting.target) {
    const sensor::PixelBox& box = sighting.target->box;
    line["target_box_px"] = {{"u", box.u_px}, {"v", box.v_px}, {"w", box.w_px}, {"h", box.h_px}};
  }
  line["target_pixels"] = sighting.target ? sighting.target->pixels : 0;
  line["blobs"] = sighting.blobs.size();
  line["clipped"] = sighting.clipped_pixels;
  if (sighting.target) {
    line["center_px"] = {{"u", sighting.target->center_px.x()},
                         {"v", sighting.target->center_px.y()}};
    line["bottom_px"] = {{"u", sighting.bottom_px.x()}, {"v", sighting.bottom_px.y()}};
  }
  return line;
}

void Tell(const std::string& file, const attention::TargetSighting& sighting) {
  std::cout << file << ": ";
  if (!sighting.target) {
    std::cout << "no target (" << sighting.color_pixels << " pixels of the colour)\n";
    return;
  }
  const sensor::PixelBox& box = sighting.target->box;
  std::cout << "target of " << sighting.target->pixels << " pixels at " << box.u_px << ","
            << box.v_px << " size " << box.w_px << "x" << box.h_px << ", " << sighting.blobs.size()
            << " blobs, " << sighting.clipped_pixels << " clipped pixels"
            << (sighting.touched.any() ? ", leaves the image" : "") << "\n";
}

Status SegmentOne(const SegmentArguments& arguments, const attention::TargetFinder& finder,
                  const std::string& file) {
  const Result<sensor::Image> image = LoadImage(file);
  if (!image.ok()) return image.status();
  const attention::TargetSighting sighting = finder.Find(*image);
  if (!arguments.mask_dir.empty()) {
    const std::string name = std::filesystem::path(file).stem().string() + "_mask.png";
    const Status saved = SaveGrayPng(std::filesystem::path(arguments.mask_dir) / name,
                                     sighting.mask, sighting.width_px, sighting.height_px);
    if (!saved.ok()) return saved;
  }
  if (arguments.json) {
    std::cout << ToJson(file, sighting).dump(-1, ' ', false, Json::error_handler_t::replace)
              << "\n";
  } else {
    Tell(file, sighting);
  }
  return Status::Ok();
}

// Masks are named after their images: two images of one name would share one.
Status CheckMaskNames(const SegmentArguments& arguments) {
  if (arguments.mask_dir.empty()) return Status::Ok();
  std::error_code error;
  std::filesystem::create_directories(arguments.mask_dir, error);
  if (error) return Status::Error(arguments.mask_dir + ": cannot create: " + error.message());
  std::set<std::string> stems;
  for (const std::string& file : arguments.images) {
    if (!stems.insert(std::filesystem::path(file).stem().string()).second) {
      return Status::Error(file + ": another image of that name is given, their masks would be " +
                           "one file; segment them into different folders");
    }
  }
  return Status::Ok();
}

int Segment(const SegmentArguments& arguments) {
  const Result<attention::ColorModel> model = LoadColorModel(arguments.color);
  if (!model.ok()) {
    std::cerr << "geon segment: " << model.message() << "\n";
    return kFailed;
  }
  const Status names = CheckMaskNames(arguments);
  if (!names.ok()) {
    std::cerr << "geon segment: " << names.message() << "\n";
    return kFailed;
  }
  attention::AttentionOptions options;
  options.erosion_neighbors = arguments.erosion_neighbors;
  options.min_target_pixels = arguments.min_pixels;
  const attention::TargetFinder finder(*model, options);
  int exit_code = kOk;
  for (const std::string& file : arguments.images) {
    const Status status = SegmentOne(arguments, finder, file);
    if (status.ok()) continue;
    std::cerr << "geon segment: " << status.message() << "\n";
    exit_code = kFailed;
  }
  return exit_code;
}

}  // namespace

void AddSegmentCommand(CLI::App& app, int* exit_code) {
  auto arguments = std::make_shared<SegmentArguments>();
  CLI::App* command = app.add_subcommand(
      "segment", "Finds the target in colour images: mask, blobs and box (thesis 4.1-4.2.1).");
  command->add_option("IMAGE", arguments->images, "Colour images: PNG, JPEG, BMP, TIFF, PNM")
      ->required();
  command
      ->add_option("--color", arguments->color,
                   "super-red, thesis-lab, thesis-lab-sun, or a file of geon teach")
      ->capture_default_str();
  command->add_option("-o", arguments->mask_dir,
                      "Folder for the masks: NAME_mask.png, 255 on the target");
  command
      ->add_option("--erosion", arguments->erosion_neighbors,
                   "Neighbours that must all have the colour: 4 or 8")
      ->check(CLI::IsMember({4, 8}))
      ->capture_default_str();
  command->add_option("--min-pixels", arguments->min_pixels, "A smaller largest blob is no target")
      ->check(CLI::Range(1, 100000000))
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "One JSON object a line, in order");
  command->callback([arguments, exit_code] { *exit_code = Segment(*arguments); });
}

}  // namespace geon::cli
