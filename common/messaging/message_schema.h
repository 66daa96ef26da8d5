#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace geon::messaging {

// A message type as its .lcm file declares it. The files are built into the program, so that
// messages can be checked and printed without a line of code per type.
struct SchemaField {
  std::string name;
  std::string type;                     // "double", "string", "image_t", ...
  std::vector<std::string> dimensions;  // "16" or the name of the field that holds the count
};
struct MessageSchema {
  std::string name;  // "image_t"
  std::vector<SchemaField> fields;
};

// Every type of the package, by name.
const std::map<std::string, MessageSchema, std::less<>>& AllSchemas();
// Parses the text of one .lcm file (one struct).
Result<MessageSchema> ParseSchema(std::string_view text);

// LCM's fingerprint of a type, computed from the declaration exactly as lcm-gen does.
uint64_t Fingerprint(const MessageSchema& schema);
// The name of the type with this fingerprint; empty when it is none of ours.
std::string_view TypeNameOf(uint64_t fingerprint);
// Sum of all fingerprints: equal for programs built from the same types.
int64_t TypesHash();

// Walks the bytes of a message by the schema of its type: every count must be non-negative and its
// elements must be there, strings must end, nothing may be left over. The generated decoders check
// none of this before they allocate.
Status CheckMessage(std::string_view type, std::span<const uint8_t> bytes);

// The message as JSON; byte arrays (images) as {"bytes": n}, NaN as null. The type follows from the
// fingerprint; the same checks as CheckMessage.
Result<nlohmann::ordered_json> MessageToJson(std::span<const uint8_t> bytes);

}  // namespace geon::messaging
