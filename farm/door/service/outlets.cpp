#include "farm/door/service/outlets.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "os/clock.hpp"

namespace farm {

namespace {

using nlohmann::json;

constexpr std::size_t kLongestSubject = 200;
/// Beginnings of subjects that mean something to the server, or to other members of the farm.
constexpr std::array<std::string_view, 3> kTaken{"$", "axisd.", "axisd_host."};

}  // namespace

Outlets::~Outlets() {
  const std::list<Outlet> last = std::exchange(all_, {});
}

bool Outlets::is_subject(std::string_view subject) noexcept {
  const auto begins = [subject](std::string_view taken) { return subject.starts_with(taken); };
  const auto is_none = [](char c) { return c <= ' ' || c > '~' || c == '*' || c == '>'; };
  return !subject.empty() && subject.size() <= kLongestSubject && !subject.starts_with('.') &&
         !subject.ends_with('.') && subject.find("..") == std::string_view::npos &&
         std::ranges::none_of(subject, is_none) && std::ranges::none_of(kTaken, begins);
}

void Outlets::subscribe(const Source& source, const std::string& subject, std::string_view method,
                        const json& params, gateway::OnAnswer on_answer) {
  if (find(source.unit, subject) == nullptr)
    if (const auto opened = open(source, subject); !opened) return on_answer(tl::unexpected{opened.error()});
  static_cast<void>(ask(source.unit, subject, method, params, std::move(on_answer)));
}

tl::expected<Outlets::Outlet*, gateway::Error> Outlets::open(const Source& source, const std::string& subject) {
  const auto is_there = [&source](const Outlet& each) { return each.source.path == source.path; };
  if (static_cast<std::size_t>(std::ranges::count_if(all_, is_there)) >= kMostOfDaemon)
    return tl::unexpected{gateway::refuse(
        gateway::Refused::TooMany, fmt::format("{} clients are told something by this daemon", kMostOfDaemon))};
  auto client = daemons_.connect(source.path, *this);
  if (!client) return tl::unexpected{gateway::refuse(gateway::Refused::NoDaemon, client.error())};
  return &all_.emplace_back(Outlet{source, subject, os::monotonic_time(), *std::move(client)});
}

bool Outlets::ask(const UnitName& unit, std::string_view subject, std::string_view method, const json& params,
                  gateway::OnAnswer on_answer) {
  Outlet* const outlet = find(unit, subject);
  if (outlet == nullptr) return false;
  outlet->heard = os::monotonic_time();
  json with_unit = params;
  with_unit["unit"] = outlet->source.name;
  outlet->client->ask(method, with_unit, std::move(on_answer));
  return true;
}

bool Outlets::keep(const UnitName& unit, std::string_view subject) noexcept {
  Outlet* const outlet = find(unit, subject);
  if (outlet != nullptr) outlet->heard = os::monotonic_time();
  return outlet != nullptr;
}

bool Outlets::end(const UnitName& unit, std::string_view subject) {
  const Outlet* const outlet = find(unit, subject);
  return std::erase_if(all_, [outlet](const Outlet& each) { return &each == outlet; }) > 0;
}

void Outlets::sweep() {
  const Time now = os::monotonic_time();
  std::erase_if(all_, [now](const Outlet& each) { return now - each.heard > kPatience; });
}

/// What is long goes on as it has come, if its unit has the same name in the farm.
bool Outlets::on_notice_text(gateway::DaemonClient& client, std::string_view key, std::string_view value) {
  const Outlet* const outlet = find(client);
  if (outlet == nullptr) return true;
  if (key == "event" || outlet->source.name != outlet->source.unit.text()) return false;
  messages_.publish(outlet->subject, fmt::format("{{\"{}\":{}}}", key, value));
  return true;
}

void Outlets::on_notice(gateway::DaemonClient& client, std::string_view key, const json& value) {
  const Outlet* const outlet = find(client);
  if (outlet == nullptr || !value.is_object() || value.value("unit", json{}) != outlet->source.name) return;
  json line{{key, value}};
  line[key]["unit"] = outlet->source.unit.text();
  messages_.publish(outlet->subject, line.dump(-1, ' ', false, json::error_handler_t::replace));
}

void Outlets::on_gone(gateway::DaemonClient& client, const std::string&) {
  std::erase_if(all_, [&client](const Outlet& each) { return each.client.get() == &client; });
}

Outlets::Outlet* Outlets::find(const UnitName& unit, std::string_view subject) noexcept {
  const auto found = std::ranges::find_if(
      all_, [&](const Outlet& each) { return each.source.unit == unit && each.subject == subject; });
  return found != all_.end() ? &*found : nullptr;
}

Outlets::Outlet* Outlets::find(const gateway::DaemonClient& client) noexcept {
  const auto found = std::ranges::find(all_, &client, [](const Outlet& each) { return each.client.get(); });
  return found != all_.end() ? &*found : nullptr;
}

}  // namespace farm
