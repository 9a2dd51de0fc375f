#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "trace/export/result.hpp"

namespace trace {

/// Puts a result together out of the pages of `trace.read`: as long as next() has something, that is asked for,
/// and what comes is taken.
class ResultReader {
 public:
  /// Result @p number; the latest without.
  explicit ResultReader(std::optional<std::uint64_t> number = std::nullopt) noexcept : number_{number} {}

  /// The parameters of `trace.read` for the next page; nothing when all is there.
  std::optional<nlohmann::json> next() const;
  /// Takes the page that was asked for; what is wrong with it, if anything.
  [[nodiscard]] tl::expected<void, std::string> take(const nlohmann::json& page);
  /// What has been read.
  Result result() && { return std::move(result_); }

 private:
  bool take_item(const nlohmann::json& item);

  std::optional<std::uint64_t> number_;
  std::size_t part_ = 0;
  std::size_t from_ = 0;
  Result result_;
};

}  // namespace trace
