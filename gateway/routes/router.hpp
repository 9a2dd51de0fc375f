#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "gateway/base/error.hpp"
#include "gateway/routes/route.hpp"

namespace gateway {

/// The value of a part of a path: the name between its braces, and the text.
using PathValue = std::pair<std::string_view, std::string>;

/// The row for a request.
struct Match {
  const Route* route = nullptr;
  std::vector<PathValue> values{};

  /// The text of {@p name}; empty if the path has none.
  [[nodiscard]] std::string_view value(std::string_view name) const noexcept;
};

/// The row for @p verb at @p path, which is percent-encoded as it was sent; HEAD asks for what GET does. Else
/// no-such-path, or method-not-allowed with the verbs that there are. Words stand before placeholders.
[[nodiscard]] tl::expected<Match, Error> find_route(std::string_view verb, std::string_view path);

/// The verbs of @p path for the header Allow, OPTIONS included; empty if there is no such path.
[[nodiscard]] std::string verbs_of(std::string_view path);

/// The unit that the path of @p match names: "vcan0/5"; empty if it names none.
[[nodiscard]] std::string unit_of(const Match& match);

}  // namespace gateway
