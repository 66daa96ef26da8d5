#include "config/yaml_section.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <type_traits>
#include <utility>

#include "base/angles.h"

namespace geon::config {

namespace {

// A robot or world file is small: what is deeper or larger than this is an accident or an attack
// (aliases can unfold without end).
constexpr int kMaxDepth = 32;
constexpr int kMaxNodes = 200000;

int LineOf(const YAML::Node& node) { return node.Mark().is_null() ? 1 : node.Mark().line + 1; }

// A quoted scalar is text, whatever it looks like.
bool IsPlainScalar(const YAML::Node& node) { return node.IsScalar() && node.Tag() != "!"; }

template <typename T>
bool ParseNumber(const YAML::Node& node, T* value) {
  if (!IsPlainScalar(node)) return false;
  std::string_view text = node.Scalar();
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  T parsed{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), parsed);
  if (error != std::errc() || end != text.data() + text.size()) return false;
  if constexpr (std::is_floating_point_v<T>) {
    if (!std::isfinite(parsed)) return false;
  }
  *value = parsed;
  return true;
}

bool ParseText(const YAML::Node& node, std::string* value) {
  if (!node.IsScalar()) return false;
  *value = node.Scalar();
  return true;
}

}  // namespace

struct YamlSource {
  struct Section {
    YAML::Node node;
    bool absent = false;  // stands for a missing map: already reported, silent from then on
    std::set<std::string> used;
    std::set<std::string> failed;
  };
  std::string name;
  std::vector<Section> sections;
  std::map<std::pair<size_t, std::string>, std::vector<size_t>> below;
  std::multimap<int, std::string> errors;  // by line

  void Fail(int line, const std::string& message) {
    errors.emplace(line, name + ":" + std::to_string(line) + ": " + message);
  }
  size_t Add(const YAML::Node& node, bool absent) {
    sections.push_back({node, absent, {}, {}});
    return sections.size() - 1;
  }

  // The value of a key somebody reads; nothing (and an error, once) when the key is missing.
  const YAML::Node* Use(size_t section_index, const std::string& key);
  void Mistype(size_t section_index, const std::string& key, int line, const std::string& wanted);
  // Reports duplicate keys anywhere below, also in sections that nobody reads.
  void FindDuplicates(const YAML::Node& node, int depth, int* budget);

 private:
  YAML::Node found_;
};

const YAML::Node* YamlSource::Use(size_t section_index, const std::string& key) {
  Section& section = sections[section_index];
  if (section.absent) return nullptr;
  const bool first_time = section.used.insert(key).second;
  for (const auto& entry : section.node) {
    if (entry.first.IsScalar() && entry.first.Scalar() == key) {
      found_.reset(entry.second);
      return &found_;
    }
  }
  section.failed.insert(key);
  if (first_time) Fail(LineOf(section.node), "'" + key + "' is missing");
  return nullptr;
}

void YamlSource::Mistype(size_t section_index, const std::string& key, int line,
                         const std::string& wanted) {
  if (sections[section_index].failed.insert(key).second) {
    Fail(line, "'" + key + "' must be " + wanted);
  }
}

void YamlSource::FindDuplicates(const YAML::Node& node, int depth, int* budget) {
  if (--*budget < 0) return;
  if (depth > kMaxDepth) {
    *budget = -1;
    return;
  }
  if (node.IsSequence()) {
    for (const auto& element : node) FindDuplicates(element, depth + 1, budget);
  }
  if (!node.IsMap()) return;
  std::map<std::string, int> first_line;
  for (const auto& entry : node) {
    if (!entry.first.IsScalar()) {
      Fail(LineOf(entry.first), "a key must be a word");
      continue;
    }
    const auto [it, fresh] = first_line.emplace(entry.first.Scalar(), LineOf(entry.first));
    if (!fresh) {
      Fail(LineOf(entry.first),
           "'" + it->first + "' is given twice (first in line " + std::to_string(it->second) + ")");
    }
    FindDuplicates(entry.second, depth + 1, budget);
  }
}

YamlSection::YamlSection(std::shared_ptr<YamlSource> source, size_t node)
    : source_(std::move(source)), node_(node) {
  const YamlSource::Section& section = source_->sections[node_];
  if (section.absent) return;
  for (const auto& entry : section.node) {
    if (entry.first.IsScalar()) keys_.push_back(entry.first.Scalar());
  }
}

bool YamlSection::Has(const std::string& key) const {
  return std::find(keys_.begin(), keys_.end(), key) != keys_.end();
}

void YamlSection::Read(const std::string& key, bool* value) {
  const YAML::Node* node = source_->Use(node_, key);
  if (node == nullptr) return;
  if (IsPlainScalar(*node) && (node->Scalar() == "true" || node->Scalar() == "false")) {
    *value = node->Scalar() == "true";
  } else {
    source_->Mistype(node_, key, LineOf(*node), "true or false");
  }
}

void YamlSection::Read(const std::string& key, int* value) {
  const YAML::Node* node = source_->Use(node_, key);
  if (node != nullptr && !ParseNumber(*node, value)) {
    source_->Mistype(node_, key, LineOf(*node), "a whole number");
  }
}

void YamlSection::Read(const std::string& key, double* value) {
  const YAML::Node* node = source_->Use(node_, key);
  if (node != nullptr && !ParseNumber(*node, value)) {
    source_->Mistype(node_, key, LineOf(*node), "a finite number");
  }
}

void YamlSection::Read(const std::string& key, std::string* value) {
  const YAML::Node* node = source_->Use(node_, key);
  if (node != nullptr && !ParseText(*node, value)) {
    source_->Mistype(node_, key, LineOf(*node), "text");
  }
}

void YamlSection::Read(const std::string& key, std::vector<double>* value) {
  const YAML::Node* node = source_->Use(node_, key);
  if (node == nullptr) return;
  std::vector<double> numbers;
  bool good = node->IsSequence();
  if (good) {
    for (const auto& element : *node) {
      numbers.push_back(0.0);
      good = good && ParseNumber(element, &numbers.back());
    }
  }
  if (good) {
    *value = std::move(numbers);
  } else {
    source_->Mistype(node_, key, LineOf(*node), "a list of finite numbers");
  }
}

void YamlSection::Read(const std::string& key, std::vector<std::string>* value) {
  const YAML::Node* node = source_->Use(node_, key);
  if (node == nullptr) return;
  std::vector<std::string> texts;
  bool good = node->IsSequence();
  if (good) {
    for (const auto& element : *node) {
      texts.emplace_back();
      good = good && ParseText(element, &texts.back());
    }
  }
  if (good) {
    *value = std::move(texts);
  } else {
    source_->Mistype(node_, key, LineOf(*node), "a list of words");
  }
}

void YamlSection::ReadNumbers(const std::string& key, int count, double* values) {
  const YAML::Node* node = source_->Use(node_, key);
  if (node == nullptr) return;
  std::vector<double> numbers;
  bool good = node->IsSequence() && node->size() == static_cast<size_t>(count);
  if (good) {
    for (const auto& element : *node) {
      numbers.push_back(0.0);
      good = good && ParseNumber(element, &numbers.back());
    }
  }
  if (good) {
    std::copy(numbers.begin(), numbers.end(), values);
  } else {
    source_->Mistype(node_, key, LineOf(*node),
                     "a list of " + std::to_string(count) + " finite numbers");
  }
}

void YamlSection::ReadAngle(const std::string& key, double* value_rad) {
  double value_deg = DegreesFromRadians(*value_rad);
  const YAML::Node* node = source_->Use(node_, key);
  if (node == nullptr) return;
  if (ParseNumber(*node, &value_deg)) {
    *value_rad = RadiansFromDegrees(value_deg);
  } else {
    source_->Mistype(node_, key, LineOf(*node), "a finite number of degrees");
  }
}

YamlSection YamlSection::Child(const std::string& key) {
  const auto known = source_->below.find({node_, key});
  if (known != source_->below.end()) return YamlSection(source_, known->second.front());
  const YAML::Node* node = source_->Use(node_, key);
  if (node != nullptr && !node->IsMap()) {
    source_->Mistype(node_, key, LineOf(*node), "a map");
    node = nullptr;
  }
  const YAML::Node child = node != nullptr ? *node : source_->sections[node_].node;
  const size_t index = source_->Add(child, node == nullptr);
  source_->below[{node_, key}] = {index};
  return YamlSection(source_, index);
}

std::vector<YamlSection> YamlSection::Children(const std::string& key) {
  std::vector<YamlSection> children;
  if (!Has(key)) return children;
  const auto known = source_->below.find({node_, key});
  if (known == source_->below.end()) {
    std::vector<size_t>& indices = source_->below[{node_, key}];
    const YAML::Node list = *source_->Use(node_, key);
    if (!list.IsSequence()) source_->Mistype(node_, key, LineOf(list), "a list of maps");
    for (size_t i = 0; list.IsSequence() && i < list.size(); ++i) {
      if (list[i].IsMap()) {
        indices.push_back(source_->Add(list[i], false));
      } else {
        source_->Fail(LineOf(list[i]), "every entry of '" + key + "' must be a map");
      }
    }
  }
  for (const size_t index : source_->below[{node_, key}]) {
    children.push_back(YamlSection(source_, index));
  }
  return children;
}

void YamlSection::Check(bool holds, const std::string& key, const std::string& rule) {
  YamlSource::Section& section = source_->sections[node_];
  if (holds || section.absent || section.failed.count(key) > 0) return;
  int line = LineOf(section.node);
  for (const auto& entry : section.node) {
    if (entry.first.IsScalar() && entry.first.Scalar() == key) line = LineOf(entry.first);
  }
  section.failed.insert(key);
  source_->Fail(line, "'" + key + "' " + rule);
}

void YamlSection::Fail(const std::string& message) {
  const YamlSource::Section& section = source_->sections[node_];
  if (!section.absent) source_->Fail(LineOf(section.node), message);
}

void YamlSection::Ignore(const std::string& key) { source_->sections[node_].used.insert(key); }

std::string YamlSection::Where() const {
  return source_->name + ":" + std::to_string(LineOf(source_->sections[node_].node));
}

Result<YamlDocument> YamlDocument::Load(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  if (std::filesystem::is_directory(file) || !stream || !(text << stream.rdbuf())) {
    return Status::Error(file.string() + ": cannot be read as a YAML file");
  }
  return Parse(text.str(), file.string());
}

Result<YamlDocument> YamlDocument::Parse(const std::string& text, const std::string& name) {
  auto source = std::make_shared<YamlSource>();
  source->name = name;
  std::vector<YAML::Node> documents;
  try {
    documents = YAML::LoadAll(text);
  } catch (const YAML::Exception& error) {
    return Status::Error(name + ":" + std::to_string(error.mark.line + 1) + ": " + error.msg);
  }
  if (documents.size() != 1 || !documents.front().IsMap()) {
    return Status::Error(name + ":1: the file must be one map (key: value)");
  }
  int budget = kMaxNodes;
  source->FindDuplicates(documents.front(), 0, &budget);
  if (budget < 0) return Status::Error(name + ": too deep or too large");
  source->Add(documents.front(), false);
  return YamlDocument(std::move(source));
}

YamlSection YamlDocument::root() const { return YamlSection(source_, 0); }

Status YamlDocument::Finish() const {
  std::multimap<int, std::string> errors = source_->errors;
  for (const YamlSource::Section& section : source_->sections) {
    if (section.absent) continue;
    std::set<std::string> reported;
    for (const auto& entry : section.node) {
      if (!entry.first.IsScalar()) continue;
      const std::string& key = entry.first.Scalar();
      if (section.used.count(key) > 0 || !reported.insert(key).second) continue;
      const int line = LineOf(entry.first);
      errors.emplace(
          line, source_->name + ":" + std::to_string(line) + ": '" + key + "' is not a known key");
    }
  }
  if (errors.empty()) return Status::Ok();
  std::string message;
  for (const auto& [line, text] : errors) message += (message.empty() ? "" : "\n") + text;
  return Status::Error(message);
}

}  // namespace geon::config
