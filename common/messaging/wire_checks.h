#pragma once

#include <cmath>
#include <initializer_list>
#include <string>

#include "base/contracts.h"
#include "base/status.h"

namespace geon::messaging {

// What the conversions of messaging/wire.h share.

// First error of a conversion; later ones are not interesting.
class FieldChecks {
 public:
  void Require(bool holds, const char* field, const std::string& rule) {
    if (!holds && status_.ok()) status_ = Status::Error(std::string(field) + " " + rule);
  }
  void Finite(const char* field, double value) {
    Require(std::isfinite(value), field, "is not a finite number");
  }
  // Enumerations are 0 ... last.
  template <typename Enum>
  Enum Enumeration(const char* field, int32_t value, Enum last) {
    const bool known = value >= 0 && value <= static_cast<int32_t>(last);
    Require(known, field, "has the unknown value " + std::to_string(value));
    return known ? static_cast<Enum>(value) : Enum{};
  }
  // The value of a part, or its default when the part itself is bad.
  template <typename T>
  T Part(const char* field, const Result<T>& part) {
    if (!part.ok() && status_.ok()) status_ = part.status().In(field);
    return part.ok() ? *part : T{};
  }

  const Status& status() const { return status_; }
  template <typename T>
  Result<T> Finish(T value) const {
    if (!status_.ok()) return status_;
    return value;
  }

 private:
  Status status_;
};

// A count for the wire.
template <typename Container>
int32_t WireCount(const Container& container) {
  Require(container.size() <= 0x7fffffff, "too many elements for a message");
  return static_cast<int32_t>(container.size());
}

}  // namespace geon::messaging
