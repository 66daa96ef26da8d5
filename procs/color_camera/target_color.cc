#include "procs/color_camera/target_color.h"

#include <string>

#include "attention/color_model_text.h"
#include "config/text_file.h"

namespace geon::color_camera {
namespace {

Result<attention::ColorModel> LoadColor(const std::string& name_or_file,
                                        const std::filesystem::path& robot_file) {
  if (auto named = attention::NamedColorModel(name_or_file)) return *named;
  const std::filesystem::path file = robot_file.parent_path() / name_or_file;
  const Result<std::string> text = config::ReadFile(file);
  if (!text.ok()) return text.status();
  return attention::ParseColorModel(*text, file.string());
}

}  // namespace

void ReadTargetColor(config::YamlSection planner, const std::filesystem::path& robot_file,
                     attention::ColorModel* target_color) {
  std::string name_or_file;
  planner.Read("target_color", &name_or_file);
  const auto model = LoadColor(name_or_file, robot_file);
  planner.Check(model.ok(), "target_color",
                "must be a colour model's name or file: " + model.message());
  if (model.ok()) *target_color = *model;
}

}  // namespace geon::color_camera
