#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace geon::recognition {

// Measurements under their names, in the order in which they were added. The names are kept only
// where they are asked for: a recognition needs the numbers alone.
//
// Source: none needed, a list.
class EvidenceList {
 public:
  explicit EvidenceList(bool with_names = false) : with_names_(with_names) {}

  // What is added from here on is called `group`.name.
  void BeginGroup(std::string_view group) {
    if (with_names_) group_ = group;
  }
  void Add(std::string_view name, double value) { Add(name, "", value); }
  // The name in two parts, which are joined only where it is kept.
  void Add(std::string_view name, std::string_view more, double value) {
    values_.push_back(static_cast<float>(value));
    if (with_names_) names_.push_back(group_ + "." + std::string(name) + std::string(more));
  }
  void Add(std::string_view name, size_t number, double value) {
    values_.push_back(static_cast<float>(value));
    if (with_names_) {
      names_.push_back(group_ + "." + std::string(name) + std::to_string(number));
    }
  }

  const std::vector<float>& values() const { return values_; }
  const std::vector<std::string>& names() const { return names_; }

 private:
  bool with_names_;
  std::string group_;
  std::vector<float> values_;
  std::vector<std::string> names_;
};

}  // namespace geon::recognition
