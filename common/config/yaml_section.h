#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/status.h"

namespace geon::config {

struct YamlSource;  // the parsed file, the keys read so far and the errors found so far

// One map of a YAML file, read strictly: what is missing, ill-typed, duplicate or unknown is an
// error with file and line. Errors are collected, so that one run reports all of them:
//
//   Result<YamlDocument> document = YamlDocument::Load("robot.yaml");
//   YamlSection ptu = document->root().Child("ptu");
//   ptu.Read("port", &options.port);                       // required
//   ptu.ReadOptional("reply_timeout_s", &options.reply_timeout_s);  // keeps the default
//   ptu.ReadAngle("tilt_offset_deg", &options.tilt_offset_rad);     // degrees in the file
//   ptu.Check(options.reply_timeout_s > 0, "reply_timeout_s", "must be positive");
//   Status status = document->Finish();                    // every error, one a line
class YamlSection {
 public:
  bool Has(const std::string& key) const;

  // Required values. The target keeps its value when the key is missing or ill-typed.
  void Read(const std::string& key, bool* value);
  void Read(const std::string& key, int* value);
  void Read(const std::string& key, double* value);  // finite
  void Read(const std::string& key, std::string* value);
  void Read(const std::string& key, std::vector<double>* value);
  void Read(const std::string& key, std::vector<std::string>* value);
  // A list of exactly `count` numbers, or an error.
  void ReadNumbers(const std::string& key, int count, double* values);
  // Written in degrees, delivered in radians.
  void ReadAngle(const std::string& key, double* value_rad);

  // As above, but silent when the key is absent.
  template <typename T>
  void ReadOptional(const std::string& key, T* value) {
    if (Has(key)) Read(key, value);
  }
  void ReadOptionalAngle(const std::string& key, double* value_rad) {
    if (Has(key)) ReadAngle(key, value_rad);
  }

  // A map below this one. A missing required child is an error and reads as empty without further
  // ones.
  YamlSection Child(const std::string& key);
  // A list of maps; absent means none.
  std::vector<YamlSection> Children(const std::string& key);

  // States a rule for a key that was read: "file:line: key must be ...".
  void Check(bool holds, const std::string& key, const std::string& rule);
  // An error about this section itself.
  void Fail(const std::string& message);
  // A key this reader knows of but leaves to others (sections of other programs in a shared file).
  void Ignore(const std::string& key);

  // "file:line" of this section, for messages.
  std::string Where() const;
  const std::vector<std::string>& Keys() const { return keys_; }

 private:
  friend class YamlDocument;
  YamlSection(std::shared_ptr<YamlSource> source, size_t node);
  std::shared_ptr<YamlSource> source_;
  size_t node_ = 0;
  std::vector<std::string> keys_;
};

class YamlDocument {
 public:
  // Errors: the file cannot be read, is not YAML, or is not a map.
  static Result<YamlDocument> Load(const std::filesystem::path& file);
  // The same from text; `name` stands for the file in messages.
  static Result<YamlDocument> Parse(const std::string& text, const std::string& name);

  YamlSection root() const;
  // All errors so far and every key nobody read or ignored, one a line; ok when there is none.
  Status Finish() const;

 private:
  explicit YamlDocument(std::shared_ptr<YamlSource> source) : source_(std::move(source)) {}
  std::shared_ptr<YamlSource> source_;
};

}  // namespace geon::config
