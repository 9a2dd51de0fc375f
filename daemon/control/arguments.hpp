#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "control/error.hpp"

namespace axisd {

/// A parameter of a method, or why it cannot be taken.
template <class Value>
using Taken = tl::expected<Value, control::Error>;

/// The part of a list that a method is asked for: from which place on, and how many at most.
struct Page {
  std::size_t from;
  std::size_t count;
};
/// What "from" (0 to `last`) and "count" (1 to `most`, `usual` if absent) may be.
struct PageLimits {
  std::int64_t last;
  std::int64_t most;
  std::int64_t usual;
};

/// The parameters of a method, taken one by one: nothing throws, whatever they are. One that is null counts as
/// absent.
class Arguments {
 public:
  /// @p params outlive this.
  explicit Arguments(const nlohmann::json& params) noexcept : params_{params} {}

  /// The value of @p key; nullptr if it is absent.
  const nlohmann::json* find(std::string_view key) const noexcept;
  bool has(std::string_view key) const noexcept { return find(key) != nullptr; }

  /// An integer @p low to @p high; @p absent if there is none.
  Taken<std::int64_t> integer(std::string_view key, std::int64_t low, std::int64_t high,
                              std::optional<std::int64_t> absent = std::nullopt) const;
  /// A number @p low to @p high.
  Taken<double> number(std::string_view key, double low, double high,
                       std::optional<double> absent = std::nullopt) const;
  /// true or false.
  Taken<bool> flag(std::string_view key, std::optional<bool> absent = std::nullopt) const;
  /// "from" and "count".
  Taken<Page> page(const PageLimits& limits) const;
  static constexpr std::size_t kLongestText = 200;
  /// A text of at most kLongestText bytes.
  Taken<std::string> text(std::string_view key, std::optional<std::string> absent = std::nullopt) const;
  /// The place of a text among @p choices.
  Taken<std::size_t> choice(std::string_view key, std::span<const std::string_view> choices,
                            std::optional<std::size_t> absent = std::nullopt) const;

 private:
  const nlohmann::json& params_;
};

/// @p value for a message, cut to a length that a line has room for.
std::string shown(const nlohmann::json& value);

/// BadParameter: "KEY: expected @p expected, got @p value"; nullptr: nothing.
control::Error unexpected_value(std::string_view key, std::string_view expected, const nlohmann::json* value);

}  // namespace axisd
