#include "procs/geon/experiment_conditions.h"

#include <set>
#include <utility>

#include "base/angles.h"
#include "evaluation/scan_conditions.h"
#include "procs/geon/svg.h"

namespace geon::cli {
namespace {

// A condition as it was given; empty when it was not.
std::string Said(const ShapeRecord& record, const char* name) {
  const auto value = record.conditions.find(name);
  if (value == record.conditions.end() || value->is_null()) return "";
  return value->is_string() ? value->get<std::string>() : value->dump();
}

bool IsSet(const ShapeRecord& record, const char* name) { return Said(record, name) == "true"; }

std::string Objects(const ShapeRecord& record) {
  std::set<std::pair<GeonLabel, std::string>> objects;
  for (const evaluation::Subject& subject : record.subjects) {
    objects.emplace(subject.truth, subject.object);
  }
  std::string text = AreThesisObjects(record)
                         ? "The " + std::to_string(objects.size()) + " objects of the thesis"
                         : std::to_string(objects.size()) + " objects";
  const std::string file = Said(record, "objects"), meshes = Said(record, "meshes");
  if (!file.empty()) text += " of " + file;
  if (!meshes.empty()) text += " from the meshes in " + meshes;
  text += " in " + std::to_string(record.subjects.size()) + " positions";
  if (meshes.empty() && Said(record, "family") == "polygon") text += ", made of polygons";
  if (meshes.empty() && Said(record, "family") == "superquadric") {
    text += ", made as superquadrics";
  }
  return text;
}

std::string ShortPercent(double share_1) {
  const double percent = 100.0 * share_1;
  return Fixed(percent, percent < 1.0 ? 1 : 0) + " %";
}

std::string Fault(const std::string& name) {
  const auto stress = evaluation::FindStress(name);
  if (name.empty() || name == "none" || !stress) return name == "none" ? "No other fault." : "";
  const evaluation::FaultOptions& faults = stress->faults;
  std::string text = "Stress “" + name + "”:";
  const auto add = [&text](const std::string& what) {
    text += (text.ends_with(":") ? " " : ", ") + what;
  };
  if (faults.speckle_px > 0.0) {
    add(Fixed(faults.speckle_px, 2) + " px of noise correlated over four pixels");
  }
  if (faults.outliers_1 > 0.0) add(ShortPercent(faults.outliers_1) + " of the peaks within 20 px");
  if (faults.dropout_1 > 0.0) add(ShortPercent(faults.dropout_1) + " of the peaks missing");
  if (faults.floor_cut_m > 0.0) {
    add("points lower than " + Fixed(1000.0 * faults.floor_cut_m, 0) + " mm missing");
  }
  if (faults.misplacement_1 > 0.0) {
    add("stripes off their place by " + ShortPercent(faults.misplacement_1) + " of the target");
  }
  if (faults.attitude_rad > 0.0) {
    add("the camera's believed attitude wrong by " +
        Fixed(DegreesFromRadians(faults.attitude_rad), 1) + "°");
  }
  if (stress->scale_1 != 1.0) add("objects " + Fixed(stress->scale_1, 2) + " times as large");
  if (text.ends_with(":")) add("on a floor");
  return text + ".";
}

}  // namespace

bool AreThesisObjects(const ShapeRecord& record) {
  return Said(record, "objects").empty() && Said(record, "meshes").empty();
}

std::string ConditionsInWords(const ShapeRecord& record) {
  std::string text = Objects(record);
  const std::string elevation_deg = Said(record, "elevation_deg");
  const size_t colon = elevation_deg.find(':');
  if (colon != std::string::npos) {
    text += ", seen all round from " + elevation_deg.substr(0, colon) + "° to " +
            elevation_deg.substr(colon + 1) + "° above";
  }
  text += ".";
  const std::string range_m = Said(record, "range_m"), noise_px = Said(record, "noise_px");
  if (!range_m.empty()) text += " Camera " + range_m + " m from the middle of the object";
  if (!noise_px.empty()) text += ", noise of " + noise_px + " px on the stripe in the image";
  if (!range_m.empty()) text += ".";
  const auto stress = evaluation::FindStress(Said(record, "stress"));
  const bool floor = IsSet(record, "floor") || (stress && stress->floor);
  text += floor ? " The objects stand on a floor" : " The objects hang in the air";
  text += IsSet(record, "ortho") ? "; parallel rays, nothing hidden. "
                                 : "; what camera or laser cannot see is a gap. ";
  text += Fault(Said(record, "stress"));
  const std::string curvature = Said(record, "curvature"), smoothing = Said(record, "smoothing");
  if (!curvature.empty()) text += " Corners and curves by " + curvature + ".";
  if (!smoothing.empty()) text += " Smoothing: " + smoothing + ".";
  return text;
}

}  // namespace geon::cli
