#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "eds/sheet/names.hpp"

namespace eds {

/// One JSON object, read field by field; every refusal is a CatalogueError that starts with the place.
class JsonFields {
 public:
  /// @p place names the object in messages ("row 3 (6040:00)"); @p known are the keys it may have.
  JsonFields(const nlohmann::json& object, std::string place, std::span<const std::string_view> known);

  /// True when the field is there.
  [[nodiscard]] bool has(std::string_view key) const;
  /// A text of printable ASCII, not empty.
  [[nodiscard]] std::string text(std::string_view key) const;
  /// A list of such texts, possibly empty.
  [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;
  /// True or false.
  [[nodiscard]] bool boolean(std::string_view key) const;
  /// An integer 0..@p high.
  [[nodiscard]] std::int64_t integer(std::string_view key, std::int64_t high) const;
  /// Four hexadecimal digits.
  [[nodiscard]] std::uint16_t hexadecimal(std::string_view key) const;
  /// One of the words of @p table.
  template <class T, std::size_t N>
  [[nodiscard]] T word(std::string_view key, const std::array<Name<T>, N>& table) const {
    const std::optional<T> value = value_of(table, text(key));
    if (value) return *value;
    std::string words;
    for (const Name<T>& row : table) words += (words.empty() ? "" : ", ") + std::string{row.text};
    fail(key, "one of " + words);
  }

  /// Refuses @p key: "PLACE: field "KEY": expected EXPECTED, got WHAT STANDS THERE".
  [[noreturn]] void fail(std::string_view key, std::string_view expected) const;

 private:
  const nlohmann::json& at(std::string_view key, std::string_view expected) const;

  const nlohmann::json& object_;
  std::string place_;
};

/// Parses @p text; refuses what is not JSON and keys that stand twice in one object.
[[nodiscard]] nlohmann::json parse_json(std::string_view text);

}  // namespace eds
