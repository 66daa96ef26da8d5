#include "messaging/message_schema.h"

#include <bit>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "base/contracts.h"

namespace geon::messaging {

extern const char* const kSchemaTexts[];
extern const std::size_t kSchemaTextCount;

namespace {

using Json = nlohmann::ordered_json;

// Bytes of one element on the wire; nothing for strings and structs.
std::optional<size_t> PrimitiveSize(std::string_view type) {
  if (type == "int8_t" || type == "byte" || type == "boolean") return 1;
  if (type == "int16_t") return 2;
  if (type == "int32_t" || type == "float") return 4;
  if (type == "int64_t" || type == "double") return 8;
  return std::nullopt;
}

bool IsBuiltIn(std::string_view type) {
  return type == "string" || PrimitiveSize(type).has_value();
}

std::optional<int64_t> NumberOf(std::string_view text) {
  int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

// ---- reading declarations
// -------------------------------------------------------------------------

std::vector<std::string> Tokens(std::string_view text) {
  std::vector<std::string> tokens;
  for (size_t i = 0; i < text.size();) {
    if (text.substr(i, 2) == "//") {
      i = std::min(text.find('\n', i), text.size());
    } else if (text.substr(i, 2) == "/*") {
      i = std::min(text.find("*/", i), text.size() - 2) + 2;
    } else if (std::isspace(static_cast<unsigned char>(text[i])) != 0) {
      ++i;
    } else if (std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_') {
      const size_t begin = i;
      while (i < text.size() &&
             (std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_')) {
        ++i;
      }
      tokens.emplace_back(text.substr(begin, i - begin));
    } else {
      tokens.emplace_back(1, text[i++]);
    }
  }
  return tokens;
}

class SchemaParser {
 public:
  explicit SchemaParser(std::string_view text) : tokens_(Tokens(text)) {}

  Result<MessageSchema> Parse() {
    MessageSchema schema;
    if (Take("package")) SkipPast(";");
    if (!Take("struct")) return Status::Error("expected 'struct', found '" + Next() + "'");
    schema.name = Next();
    if (!Take("{")) return Status::Error("expected '{' after struct " + schema.name);
    while (!Take("}")) {
      if (at_ >= tokens_.size()) return Status::Error("struct " + schema.name + " does not end");
      if (Take("const")) {
        SkipPast(";");
      } else if (Status status = ParseFields(&schema); !status.ok()) {
        return status;
      }
    }
    return schema;
  }

 private:
  Status ParseFields(MessageSchema* schema) {
    const std::string type = Next();
    do {
      SchemaField field{Next(), type, {}};
      while (Take("[")) {
        field.dimensions.push_back(Next());
        if (!Take("]")) return Status::Error("expected ']' after " + field.name);
      }
      schema->fields.push_back(std::move(field));
    } while (Take(","));
    if (!Take(";")) {
      return Status::Error("expected ';' after " + schema->name + "." + schema->fields.back().name);
    }
    return Status::Ok();
  }

  bool Take(std::string_view token) {
    if (at_ >= tokens_.size() || tokens_[at_] != token) return false;
    ++at_;
    return true;
  }
  std::string Next() { return at_ < tokens_.size() ? tokens_[at_++] : std::string(); }
  void SkipPast(std::string_view token) {
    while (at_ < tokens_.size() && tokens_[at_++] != token) {
    }
  }

  std::vector<std::string> tokens_;
  size_t at_ = 0;
};

// ---- LCM's fingerprint (lcmgen.c: lcm_struct_hash, and the rotation of the emitters)
// ----------------

int64_t HashByte(int64_t hash, char byte) {
  const auto shifted = static_cast<int64_t>(static_cast<uint64_t>(hash) << 8);
  return static_cast<int64_t>(static_cast<uint64_t>(shifted ^ (hash >> 55)) +
                              static_cast<uint64_t>(static_cast<int64_t>(byte)));
}

int64_t HashText(int64_t hash, const std::string& text) {
  hash = HashByte(hash, static_cast<char>(text.size()));
  for (const char c : text) hash = HashByte(hash, c);
  return hash;
}

// ---- walking bytes
// ----------------------------------------------------------------------------------

class MessageWalker {
 public:
  explicit MessageWalker(std::span<const uint8_t> bytes) : rest_(bytes) {}

  // Walks one struct; fills `json` unless it is null.
  Status Walk(const MessageSchema& schema, Json* json) {
    std::map<std::string, int64_t, std::less<>> integers;  // the counts of the arrays that follow
    for (const SchemaField& field : schema.fields) {
      Json value;
      if (Status status = WalkArray(field, 0, integers, json != nullptr ? &value : nullptr);
          !status.ok()) {
        return status.In(schema.name + "." + field.name);
      }
      if (field.dimensions.empty() && last_integer_) integers[field.name] = *last_integer_;
      if (json != nullptr) (*json)[field.name] = std::move(value);
    }
    return Status::Ok();
  }
  size_t rest() const { return rest_.size(); }

 private:
  Status WalkArray(const SchemaField& field, size_t dimension,
                   const std::map<std::string, int64_t, std::less<>>& integers, Json* json) {
    if (dimension == field.dimensions.size()) return WalkElement(field.type, json);
    const std::string& size_text = field.dimensions[dimension];
    const auto variable = integers.find(size_text);
    const int64_t count =
        variable != integers.end() ? variable->second : NumberOf(size_text).value_or(-1);
    if (count < 0) return Status::Error("count " + std::to_string(count) + " is negative");

    const std::optional<size_t> size = PrimitiveSize(field.type);
    const bool last = dimension + 1 == field.dimensions.size();
    const size_t least = size.value_or(1);  // a string or struct takes at least one byte
    if (static_cast<uint64_t>(count) > rest_.size() / least) {
      return Status::Error("count " + std::to_string(count) + " is more than the " +
                           std::to_string(rest_.size()) + " bytes that are left");
    }
    if (last && size && (json == nullptr || field.type == "byte")) {
      rest_ = rest_.subspan(static_cast<size_t>(count) * *size);
      if (json != nullptr) *json = {{"bytes", count}};
      return Status::Ok();
    }
    if (json != nullptr) *json = Json::array();
    for (int64_t i = 0; i < count; ++i) {
      Json element;
      if (Status status =
              WalkArray(field, dimension + 1, integers, json != nullptr ? &element : nullptr);
          !status.ok()) {
        return status.In("[" + std::to_string(i) + "]");
      }
      if (json != nullptr) json->push_back(std::move(element));
    }
    return Status::Ok();
  }

  Status WalkElement(const std::string& type, Json* json) {
    last_integer_.reset();
    if (type == "string") return WalkString(json);
    const std::optional<size_t> size = PrimitiveSize(type);
    if (!size) {
      if (json != nullptr) *json = Json::object();
      const Status status = Walk(AllSchemas().find(type)->second, json);
      last_integer_.reset();
      return status;
    }
    const std::optional<uint64_t> bits = TakeBigEndian(*size);
    if (!bits) return Status::Error("the message ends too early");
    const Json value = Value(type, *bits, *size);
    if (type != "boolean" && value.is_number_integer()) last_integer_ = value.get<int64_t>();
    if (json != nullptr) *json = value;
    return Status::Ok();
  }

  static Json Value(std::string_view type, uint64_t bits, size_t size) {
    if (type == "double") return std::bit_cast<double>(bits);
    if (type == "float") return std::bit_cast<float>(static_cast<uint32_t>(bits));
    if (type == "boolean") return bits != 0;
    if (type == "byte") return bits;
    const auto unused = static_cast<unsigned>(64 - 8 * size);
    return static_cast<int64_t>(bits << unused) >> unused;  // sign-extended
  }

  Status WalkString(Json* json) {
    const std::optional<uint64_t> bits = TakeBigEndian(4);
    if (!bits) return Status::Error("the message ends too early");
    const auto length = static_cast<int32_t>(*bits);  // the closing zero included
    if (length < 1 || static_cast<size_t>(length) > rest_.size()) {
      return Status::Error("string of " + std::to_string(length) + " bytes where " +
                           std::to_string(rest_.size()) + " are left");
    }
    const auto size = static_cast<size_t>(length);
    if (rest_[size - 1] != 0) return Status::Error("string does not end with a zero");
    if (json != nullptr) {
      *json = std::string(reinterpret_cast<const char*>(rest_.data()), size - 1);
    }
    rest_ = rest_.subspan(size);
    return Status::Ok();
  }

  std::optional<uint64_t> TakeBigEndian(size_t size) {
    if (rest_.size() < size) return std::nullopt;
    uint64_t bits = 0;
    for (size_t i = 0; i < size; ++i) bits = bits << 8 | rest_[i];
    rest_ = rest_.subspan(size);
    return bits;
  }

  std::span<const uint8_t> rest_;
  std::optional<int64_t> last_integer_;  // the value of the integer just walked
};

std::map<std::string, MessageSchema, std::less<>> ParseBuiltInSchemas() {
  std::map<std::string, MessageSchema, std::less<>> schemas;
  for (size_t i = 0; i < kSchemaTextCount; ++i) {
    Result<MessageSchema> schema = ParseSchema(kSchemaTexts[i]);
    Require(schema.ok(), "lcmtypes: " + schema.message());
    schemas.emplace(schema->name, *schema);
  }
  for (const auto& [name, schema] : schemas) {
    for (const SchemaField& field : schema.fields) {
      Require(IsBuiltIn(field.type) || schemas.count(field.type) == 1,
              "lcmtypes: " + name + "." + field.name + " has the unknown type " + field.type);
    }
  }
  return schemas;
}

const std::map<uint64_t, std::string>& NamesByFingerprint() {
  static const auto names = [] {
    std::map<uint64_t, std::string> map;
    for (const auto& [name, schema] : AllSchemas()) map.emplace(Fingerprint(schema), name);
    return map;
  }();
  return names;
}

Status WalkMessage(std::string_view type, std::span<const uint8_t> bytes, Json* json) {
  const auto schema = AllSchemas().find(type);
  Require(schema != AllSchemas().end(), "no message type " + std::string(type));
  if (bytes.size() < 8) return Status::Error("only " + std::to_string(bytes.size()) + " bytes");
  MessageWalker walker(bytes.subspan(8));
  if (Status status = walker.Walk(schema->second, json); !status.ok()) return status;
  if (walker.rest() > 0) {
    return Status::Error(std::to_string(walker.rest()) + " bytes too many for a " +
                         std::string(type));
  }
  return Status::Ok();
}

}  // namespace

const std::map<std::string, MessageSchema, std::less<>>& AllSchemas() {
  static const std::map<std::string, MessageSchema, std::less<>> schemas = ParseBuiltInSchemas();
  return schemas;
}

Result<MessageSchema> ParseSchema(std::string_view text) { return SchemaParser(text).Parse(); }

uint64_t Fingerprint(const MessageSchema& schema) {
  int64_t hash = 0x12345678;
  for (const SchemaField& field : schema.fields) {
    hash = HashText(hash, field.name);
    if (IsBuiltIn(field.type)) hash = HashText(hash, field.type);
    hash = HashByte(hash, static_cast<char>(field.dimensions.size()));
    for (const std::string& dimension : field.dimensions) {
      hash = HashByte(hash, NumberOf(dimension) ? 0 : 1);  // constant or variable
      hash = HashText(hash, dimension);
    }
  }
  auto sum = static_cast<uint64_t>(hash);
  for (const SchemaField& field : schema.fields) {
    if (!IsBuiltIn(field.type)) sum += Fingerprint(AllSchemas().find(field.type)->second);
  }
  return std::rotl(sum, 1);
}

std::string_view TypeNameOf(uint64_t fingerprint) {
  const auto it = NamesByFingerprint().find(fingerprint);
  return it == NamesByFingerprint().end() ? std::string_view() : std::string_view(it->second);
}

int64_t TypesHash() {
  uint64_t sum = 0;
  for (const auto& [fingerprint, name] : NamesByFingerprint()) sum += fingerprint;
  return static_cast<int64_t>(sum);
}

Status CheckMessage(std::string_view type, std::span<const uint8_t> bytes) {
  return WalkMessage(type, bytes, nullptr);
}

Result<nlohmann::ordered_json> MessageToJson(std::span<const uint8_t> bytes) {
  if (bytes.size() < 8) return Status::Error("only " + std::to_string(bytes.size()) + " bytes");
  uint64_t fingerprint = 0;
  for (size_t i = 0; i < 8; ++i) fingerprint = fingerprint << 8 | bytes[i];
  const std::string_view type = TypeNameOf(fingerprint);
  if (type.empty()) return Status::Error("a type that is none of ours");
  Json json = Json::object();
  if (Status status = WalkMessage(type, bytes, &json); !status.ok()) return status;
  return json;
}

}  // namespace geon::messaging
