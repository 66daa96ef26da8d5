#include <cstddef>
#include <cstdint>
#include <string>

#include "rangefinder/look_up_table.h"

// Any bytes: refused with a reason, or a table whose distances lie in its range.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const auto table =
      geon::rangefinder::ParseLookUpTable(std::string(reinterpret_cast<const char*>(data), size));
  if (!table.ok()) {
    if (table.message().empty()) __builtin_trap();
    return 0;
  }
  for (int line = 0; line < table->lines(); ++line) {
    for (const double position_px : {-1.0, 0.0, 240.0, table->PositionAt(line, 0)}) {
      const auto distance_m = table->Distance(line, position_px);
      if (distance_m && !(*distance_m >= table->first_distance_m - 1e-9 &&
                          *distance_m <= table->last_distance_m() + 1e-9)) {
        __builtin_trap();
      }
    }
  }
  geon::rangefinder::SerializeLookUpTable(*table);
  return 0;
}
