#pragma once

#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace control {

/// JSON whose members keep the order of the file.
using Json = nlohmann::ordered_json;

/// One object of a file of the protocol, read key by key. What is not as it should be ends in a std::runtime_error
/// that names the place: "fault.json: /methods/0/params/1/form: expected ..., got ...".
class Fields {
 public:
  /// @p place names the object; it has no keys but @p known.
  Fields(const Json& object, std::string place, std::span<const std::string_view> known);

  bool has(std::string_view key) const { return object_.contains(key); }
  /// Whether @p key is there and a text.
  bool is_text(std::string_view key) const {
    const Json* const value = find(key);
    return value != nullptr && value->is_string();
  }
  /// A text that is not empty; @p otherwise if the key is not there.
  std::string_view text(std::string_view key, std::string_view otherwise) const;
  std::string_view text(std::string_view key) const;
  double number(std::string_view key) const;
  double number(std::string_view key, double otherwise) const { return has(key) ? number(key) : otherwise; }
  bool flag(std::string_view key, bool otherwise) const;
  /// A list; an empty one if the key is not there.
  const Json& list(std::string_view key) const;
  /// An object; an empty one if the key is not there.
  const Json& object(std::string_view key) const;
  /// The place of @p key.
  std::string place(std::string_view key) const { return place_ + "/" + std::string{key}; }
  [[noreturn]] void refuse(std::string_view key, std::string_view expected) const;

 private:
  const Json* find(std::string_view key) const;

  const Json& object_;
  std::string place_;
};

}  // namespace control
