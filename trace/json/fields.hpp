#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "trace/signal/problem.hpp"

namespace trace {

/// The members of a JSON object, taken one by one; the first thing that is wrong is noted as the problem, and what
/// comes after it does not matter.
class Fields {
 public:
  using json = nlohmann::json;

  /// @p path stands before the keys in problems; all arguments outlive this.
  Fields(const json& object, std::string path, std::optional<Problem>& problem)
      : object_{object}, path_{std::move(path)}, problem_{problem} {}

  /// There is no other key than @p keys.
  void expect_keys(std::span<const std::string_view> keys) const;
  bool has(std::string_view key) const { return find(key) != nullptr; }
  /// The value of @p key; nullptr if there is none.
  const json* find(std::string_view key) const;
  /// @p key is not what it should be.
  void fail(std::string_view key, std::string expected) const;

  // The value of a key that is there; nothing if it is not of that kind.
  std::optional<double> number(std::string_view key, double low, double high) const;
  std::optional<std::uint64_t> integer(std::string_view key, std::uint64_t low, std::uint64_t high) const;
  std::optional<bool> flag(std::string_view key) const;
  std::optional<std::string> text(std::string_view key, const char* expected) const;
  /// An integer, or its hexadecimal digits as a text: "205", "0x205", "205h".
  std::optional<std::uint32_t> word(std::string_view key, std::uint32_t high) const;

 private:
  const json& object_;
  std::string path_;
  std::optional<Problem>& problem_;
};

}  // namespace trace
