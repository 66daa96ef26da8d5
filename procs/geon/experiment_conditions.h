#pragma once

#include <string>

#include "procs/geon/experiment_record.h"

namespace geon::cli {

// What was tried and under which conditions, in sentences: objects, views, range, noise, faults,
// surface, rays; not escaped. What the record does not say is left out.
std::string ConditionsInWords(const ShapeRecord& record);

// Whether the objects are the 28 of the thesis, so that its figures may stand beside ours.
bool AreThesisObjects(const ShapeRecord& record);

}  // namespace geon::cli
