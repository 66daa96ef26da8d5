#include "procs/geon/experiment_objects.h"

#include <algorithm>
#include <string>

#include "config/text_file.h"
#include "config/yaml_section.h"
#include "evaluation/thesis_objects.h"
#include "procs/geon/csv_table.h"
#include "sim/world_scene.h"

namespace geon::cli {
namespace {

using evaluation::ExperimentObject;

std::vector<ShownObject> Show(const std::vector<ExperimentObject>& objects,
                              evaluation::Family family) {
  std::vector<ShownObject> shown;
  for (const ExperimentObject& object : objects) {
    for (int position : object.positions) {
      geons::GeonShape shape = object.shape;
      shape.position = position;
      shown.push_back({{shape.label, object.name, position}, evaluation::ShapeMesh(shape, family)});
    }
  }
  return shown;
}

ExperimentObject ReadObject(config::YamlSection* section) {
  ExperimentObject object;
  std::string label;
  section->Read("name", &object.name);
  section->Read("geon", &label);
  const auto known = GeonLabelFromString(label);
  section->Check(known.has_value(), "geon", "must be one of the seven geons");
  object.shape.label = known.value_or(GeonLabel::kCuboid);
  section->ReadNumbers("size_m", 3, object.shape.size_m.data());
  section->ReadOptional("taper", &object.shape.taper_1);
  section->ReadOptionalAngle("bend_deg", &object.shape.bend_rad);
  std::vector<double> positions = {1.0};
  section->ReadOptional("positions", &positions);
  for (double position : positions) {
    object.shape.position = static_cast<int>(position);
    object.positions.push_back(object.shape.position);
    const Status valid = geons::Validate(object.shape);
    section->Check(valid.ok(), "geon", "must be possible: " + valid.message());
  }
  return object;
}

}  // namespace

std::vector<ShownObject> ThesisShownObjects(evaluation::Family family) {
  return Show(evaluation::ThesisObjects(), family);
}

Result<std::vector<ShownObject>> LoadShownObjects(const std::filesystem::path& file,
                                                  evaluation::Family family) {
  Result<config::YamlDocument> document = config::YamlDocument::Load(file);
  if (!document.ok()) return document.status();
  std::vector<ExperimentObject> objects;
  for (config::YamlSection& section : document->root().Children("objects")) {
    objects.push_back(ReadObject(&section));
  }
  const Status read = document->Finish();
  if (!read.ok()) return read;
  if (objects.empty()) return Status::Error(file.string() + ": no objects");
  return Show(objects, family);
}

Result<std::vector<ShownObject>> LoadShownMeshes(const std::filesystem::path& directory,
                                                 double largest_m) {
  const std::filesystem::path index = directory / "labels.csv";
  const Result<std::string> text = config::ReadFile(index);
  if (!text.ok()) return text.status();
  const CsvTable table = ParseCsv(*text);
  std::vector<ShownObject> shown;
  for (size_t row = 0; row < table.rows.size(); ++row) {
    const std::string name = table.At(row, "name"), label = table.At(row, "label");
    const auto truth = GeonLabelFromString(label);
    if (!truth) {
      return Status::Error(index.string() + ": row " + std::to_string(row + 2) +
                           ": label must be one of the seven geons, is '" + label + "'");
    }
    Result<geons::TriangleMesh> mesh = sim::LoadObj(directory / (name + ".obj"));
    if (!mesh.ok()) return mesh.status();
    Scale(largest_m / geons::Bounds(*mesh).sizes().maxCoeff(), &*mesh);
    geons::StandOnGround(&*mesh);
    shown.push_back({{*truth, name, 1}, std::move(*mesh)});
  }
  if (shown.empty()) return Status::Error(index.string() + ": no meshes");
  return shown;
}

void Scale(double factor, geons::TriangleMesh* mesh) {
  for (Eigen::Vector3d& p_m : mesh->vertices_m) p_m *= factor;
}

}  // namespace geon::cli
