#pragma once

#include <filesystem>
#include <vector>

#include "base/status.h"
#include "evaluation/random_scan.h"
#include "evaluation/shape_experiment.h"
#include "geons/triangle_mesh.h"

namespace geon::cli {

// An object in one stable position, ready to be looked at.
struct ShownObject {
  evaluation::Subject subject;
  geons::TriangleMesh mesh;  // standing on z = 0 above the origin
};

// The 28 objects of thesis section 6.1 in their 60 positions, by one of the two generators.
std::vector<ShownObject> ThesisShownObjects(evaluation::Family family);

// Objects from a file (docs/experiments.md): a list `objects` of geons as in a world file, each
// with its `name` and `positions`.
Result<std::vector<ShownObject>> LoadShownObjects(const std::filesystem::path& file,
                                                  evaluation::Family family);

// The meshes that DIR/labels.csv names (columns `name`, `label`; DIR/name.obj), as they lie in
// their files, each scaled so that its largest side measures `largest_m`.
Result<std::vector<ShownObject>> LoadShownMeshes(const std::filesystem::path& directory,
                                                 double largest_m);

void Scale(double factor, geons::TriangleMesh* mesh);

}  // namespace geon::cli
