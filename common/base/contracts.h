#pragma once

#include <stdexcept>
#include <string>

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

}  // namespace geon
