#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "gateway/live/cursor.hpp"
#include "gateway/live/line_ring.hpp"
#include "gateway/server/exchange.hpp"

namespace gateway {

/// What somebody asks for.
struct LiveRequest {
  nlohmann::json samples{};  ///< parameters of the subscription; null: not asked for
  nlohmann::json frames{};   ///< the same
  std::optional<Cursor> after{};
};

/// What @p params, `signals`, `period_ms`, `frames` and `after`, ask for of @p unit; an error if that is nothing
/// or `after` no cursor. Whether signals and period are any is for the daemon to say.
[[nodiscard]] tl::expected<LiveRequest, Error> live_request(const std::string& unit, const nlohmann::json& params);

/// A feed, and where its lines stand in the answer.
struct Positioned {
  std::uint64_t number = 0;
  std::string_view name{};  ///< "samples" or "frames"
  const LineRing* lines = nullptr;
};

/// The lines of @p feeds since the cursor @p after, and the cursor of now. Of a feed in which the cursor is not,
/// it begins now.
[[nodiscard]] Response live_answer(std::span<const Positioned> feeds, const std::optional<Cursor>& after);

}  // namespace gateway
