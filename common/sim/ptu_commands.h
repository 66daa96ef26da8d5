#pragma once

#include <string>

#include "sim/ptu_unit.h"
#include "sim/ptu_words.h"

namespace geon::sim {

// How a command is answered: "* text" or "! text", at once or when something has come to its end.
struct PtuReply {
  enum class When {
    kNow,
    kArrived,  // both axes stand (A)
    kTables,   // both axes stand and the speed tables are recomputed, `table_time_s` later
    kReset,    // the reset is over; its "!T!T!P!P" precedes the star
  };
  bool ok = true;
  std::string text;
  When when = When::kNow;
  double table_time_s = 0.0;
};

// Does what one word says (hardware card 1.2) and answers it. Whether a unit is addressed at all
// (the "_" command) is its line's business, not the unit's.
PtuReply ExecutePtuCommand(const PtuCommand& command, PtuUnit& unit);

}  // namespace geon::sim
