#include <cstddef>
#include <cstdint>
#include <string>

#include "attention/color_model_text.h"

// Any bytes: refused with a reason, or a model that survives a round trip.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace geon::attention;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto model = ParseColorModel(text, "fuzz");
  if (!model.ok()) {
    if (model.message().empty()) __builtin_trap();
    return 0;
  }
  const auto again = ParseColorModel(SerializeColorModel(*model, {}), "again");
  if (!again.ok() || !(*again == *model)) __builtin_trap();
  return 0;
}
