#include "gateway/security/access.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace gateway {
namespace {

using Outcome = tl::expected<void, Error>;

constexpr std::string_view kBearer = "bearer ";
constexpr std::size_t kQuoted = 60;

Outcome no(Refused why, std::string message) {
  return tl::unexpected{refuse(why, std::move(message))};
}

/// The beginning of @p text, fit for a message.
std::string shown(std::string_view text) {
  std::string beginning{text.substr(0, kQuoted)};
  std::ranges::replace_if(
      beginning, [](char c) { return c < ' ' || c > '~'; }, '?');
  return beginning;
}

bool contains(const std::vector<std::string>& list, const std::string& item) noexcept {
  return std::ranges::find(list, item) != list.end();
}

tl::expected<Authority, Error> check_host(const AccessRules& rules, const std::vector<std::string>& hosts) {
  if (hosts.size() != 1)
    return tl::unexpected{refuse(Refused::WrongHost, fmt::format("Host: expected one, got {}", hosts.size()))};
  auto authority = parse_authority(hosts.front());
  if (authority && is_own_host(rules, authority->host)) return *std::move(authority);
  return tl::unexpected{refuse(
      Refused::WrongHost, fmt::format("Host: \"{}\" is no name of this server; --allow-host allows further ones",
                                      shown(hosts.front())))};
}

/// A page may use the server that it comes from, and others only where they allow it.
Outcome check_origin(const AccessRules& rules, const Authority& host, const std::vector<std::string>& origins) {
  if (origins.empty()) return {};
  const auto origin = origins.size() == 1 ? parse_origin(origins.front()) : std::nullopt;
  if (origin && (origin->authority == host || contains(rules.allow_origins, origin->text()))) return {};
  return no(Refused::ForbiddenOrigin,
            fmt::format("Origin: pages of \"{}\" may not use this server; --allow-origin allows further ones",
                        shown(origins.front())));
}

/// The token in @p authorizations; nothing if it is not there as it should be.
std::optional<std::string_view> token_in(const std::vector<std::string>& authorizations) noexcept {
  if (authorizations.size() != 1) return std::nullopt;
  const std::string_view given = authorizations.front();
  const auto is_same_letter = [](char left, char right) { return (left | ' ') == right; };
  const bool is_bearer = given.size() >= kBearer.size() &&
                         std::ranges::equal(given.substr(0, kBearer.size()), kBearer, is_same_letter);
  return is_bearer ? std::optional{given.substr(kBearer.size())} : std::nullopt;
}

Outcome check_token(const AccessRules& rules, const std::vector<std::string>& authorizations) {
  if (authorizations.empty())
    return no(Refused::TokenMissing,
              "a write needs the header Authorization: Bearer TOKEN, with the token of the file");
  const auto token = token_in(authorizations);
  if (!token) return no(Refused::TokenMissing, "Authorization: expected Bearer TOKEN, once");
  if (!rules.token.empty() && equal_in_constant_time(*token, rules.token)) return {};
  return no(Refused::TokenWrong, "Authorization: the token is not that of this server");
}

}  // namespace

bool is_own_host(const AccessRules& rules, const std::string& host) noexcept {
  if (is_loopback(host) || contains(rules.allow_hosts, host)) return true;
  // A name can be made to lead here, an address cannot: where all addresses are served, each of them is one.
  return std::ranges::any_of(rules.listen, [&host](const Authority& served) {
    return served.host == host || (is_wildcard(served.host) && is_ip_address(host));
  });
}

Outcome check_access(const AccessRules& rules, const Credentials& credentials) {
  const auto host = check_host(rules, credentials.hosts);
  if (!host) return tl::unexpected{host.error()};
  if (auto outcome = check_origin(rules, *host, credentials.origins); !outcome) return outcome;
  if (!credentials.is_write) return {};
  if (rules.read_only) return no(Refused::ReadOnly, "this server only shows: it runs with --read-only");
  return check_token(rules, credentials.authorizations);
}

std::string_view name_of(TokenState state) noexcept {
  constexpr std::array<std::string_view, 4> kNames{"none", "missing", "wrong", "right"};
  return kNames[static_cast<std::size_t>(state)];
}

TokenState token_state(const AccessRules& rules, const std::vector<std::string>& authorizations) noexcept {
  if (rules.read_only || rules.token.empty()) return TokenState::None;
  const auto token = token_in(authorizations);
  if (!token) return TokenState::Missing;
  return equal_in_constant_time(*token, rules.token) ? TokenState::Right : TokenState::Wrong;
}

std::optional<std::string> shared_origin(const AccessRules& rules, const Credentials& credentials) {
  if (credentials.origins.size() != 1) return std::nullopt;
  const auto origin = parse_origin(credentials.origins.front());
  return origin && contains(rules.allow_origins, origin->text()) ? std::optional{origin->text()} : std::nullopt;
}

bool equal_in_constant_time(std::string_view left, std::string_view right) noexcept {
  if (left.size() != right.size()) return false;
  unsigned difference = 0;
  for (std::size_t at = 0; at < left.size(); ++at)
    difference |= static_cast<unsigned>(static_cast<unsigned char>(left[at])) ^
                  static_cast<unsigned>(static_cast<unsigned char>(right[at]));
  return difference == 0;
}

}  // namespace gateway
