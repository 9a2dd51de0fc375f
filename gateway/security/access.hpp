#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "gateway/base/error.hpp"
#include "gateway/security/authority.hpp"

namespace gateway {

/// What a request says of itself; each header as often as it was sent.
struct Credentials {
  std::vector<std::string> hosts{};
  std::vector<std::string> origins{};
  std::vector<std::string> authorizations{};
  bool is_write = false;
};

/// Who may do what. A web page of anybody can let a browser send requests to this machine, under a name that was
/// made to lead here (DNS rebinding) or not: so the names are checked on every request, and where a page comes
/// from whenever the browser says so.
struct AccessRules {
  std::vector<Authority> listen{};           ///< what is served
  std::vector<std::string> allow_hosts{};    ///< further names, in lower case
  std::vector<std::string> allow_origins{};  ///< of pages of other servers
  bool read_only = false;
  std::string token{};  ///< that a write has to show
};

/// Whether a client may call the server @p host: a name of this machine alone, an address that is served, or one
/// that was allowed.
[[nodiscard]] bool is_own_host(const AccessRules& rules, const std::string& host) noexcept;

/// Whether the request may be carried out, else why not.
[[nodiscard]] tl::expected<void, Error> check_access(const AccessRules& rules, const Credentials& credentials);

/// What the token of a request is.
enum class TokenState : std::uint8_t {
  None,     ///< the server has none, and refuses writes
  Missing,  ///< the request brings none, or not as it should
  Wrong,
  Right
};
/// The name of @p state as the API has it: "none", "missing", "wrong", "right".
[[nodiscard]] std::string_view name_of(TokenState state) noexcept;
/// What the token in @p authorizations is, the headers of a request.
[[nodiscard]] TokenState token_state(const AccessRules& rules,
                                     const std::vector<std::string>& authorizations) noexcept;

/// The origin that the answer names in Access-Control-Allow-Origin: that of the request if it is allowed by name.
[[nodiscard]] std::optional<std::string> shared_origin(const AccessRules& rules, const Credentials& credentials);

/// Whether both are the same, in a time that does not tell how much of them is.
[[nodiscard]] bool equal_in_constant_time(std::string_view left, std::string_view right) noexcept;

}  // namespace gateway
