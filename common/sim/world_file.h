#pragma once

#include <filesystem>
#include <string>

#include "base/status.h"
#include "sim/world.h"

namespace geon::sim {

// Reads a world file strictly: whatever is unknown, missing, impossible or outside the pen is
// refused with file, line and reason (all of it at once).
Result<World> LoadWorld(const std::filesystem::path& file);

// The same from text; `name` stands for the file in messages, meshes are looked for in `folder`.
Result<World> ParseWorld(const std::string& text, const std::string& name,
                         const std::filesystem::path& folder);

// A world as the text of a world file. Meshes keep the path they have.
std::string WorldText(const World& world);

}  // namespace geon::sim
