#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace geon {

// Thrown when a caller breaks the contract of a function: a programming error, never an outcome of
// the outside world and never one of perception.
class ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

// States a precondition. `message` names the rule and the value that broke it.
inline void Require(bool condition, const std::string& message) {
  if (!condition) throw ContractViolation(message);
}
inline void Require(bool condition, const char* message) {
  if (!condition) throw ContractViolation(message);
}
// The same for a number called `name`; the message is made only when it is needed.
template <typename Number>
void Require(bool condition, std::string_view name, Number value, std::string_view rule) {
  if (condition) return;
  throw ContractViolation(std::string(name) + " is " + std::to_string(value) + ", " +
                          std::string(rule));
}

}  // namespace geon
