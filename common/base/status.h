#pragma once

#include <optional>
#include <string>
#include <utility>

#include "base/contracts.h"

namespace geon {

// Outcome of an operation on the outside world (serial line, file, configuration): success, or a
// sentence that says what failed, where, and what to do next.
//
// Perception outcomes ("no blob", "stripe too faint") are not errors: they are part of results.
// Broken contracts are not errors either: they throw (base/contracts.h).
class [[nodiscard]] Status {
 public:
  Status() = default;
  static Status Ok() { return Status(); }
  static Status Error(std::string message) {
    Status status;
    status.message_ = std::move(message);
    return status;
  }

  bool ok() const { return !message_.has_value(); }
  // Empty when ok.
  const std::string& message() const {
    static const std::string kEmpty;
    return message_ ? *message_ : kEmpty;
  }
  // The same error, told from further up: "where: message". Success stays success.
  Status In(const std::string& where) const {
    return ok() ? Status() : Error(where + ": " + message());
  }

 private:
  std::optional<std::string> message_;
};

// A value, or the Status that says why there is none. std::expected is C++23.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : value_(std::move(value)) {}         // NOLINT(google-explicit-constructor)
  Result(Status status) : status_(std::move(status)) {  // NOLINT(google-explicit-constructor)
    Require(!status_.ok(), "Result built from a success without a value");
  }

  bool ok() const { return value_.has_value(); }
  const Status& status() const { return status_; }
  const std::string& message() const { return status_.message(); }

  const T& value() const& {
    Require(ok(), "Result::value() of an error: " + message());
    return *value_;
  }
  T& value() & {
    Require(ok(), "Result::value() of an error: " + message());
    return *value_;
  }
  T&& value() && {
    Require(ok(), "Result::value() of an error: " + message());
    return *std::move(value_);
  }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }

 private:
  std::optional<T> value_;
  Status status_;
};

}  // namespace geon
