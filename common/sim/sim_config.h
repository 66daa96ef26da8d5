#pragma once

#include <filesystem>

#include "base/status.h"
#include "sim/camera_options.h"
#include "sim/horus_emulator.h"
#include "sim/line_faults.h"
#include "sim/nomad_emulator.h"
#include "sim/ptu_emulator.h"
#include "sim/world_scene.h"

namespace geon::sim {

// The simulated individual: how it differs from its drawing, and what is wrong with its lines.
struct SimOptions {
  RendererOptions renderer;
  PtuEmulatorOptions ptu;
  HorusEmulatorOptions lasers;
  NomadEmulatorOptions base;
  LineFaultOptions ptu_faults, laser_faults, base_faults;
  geons::MeshResolution geon_mesh = kGeonMesh;  // how fine the geons' surfaces are made
};

// Reads scripts/config/sim.yaml (which explains every key) or a file like it, strictly; what it
// leaves out keeps its default.
Result<SimOptions> LoadSimOptions(const std::filesystem::path& file);
Result<SimOptions> ParseSimOptions(const std::string& text, const std::string& name);

}  // namespace geon::sim
