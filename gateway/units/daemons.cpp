#include "gateway/units/daemons.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "gateway/units/unit_list.hpp"

namespace gateway {
namespace {

using nlohmann::json;

constexpr std::chrono::seconds kPeriod{1};
constexpr std::size_t kMostKnown = 1024;  // names that are kept

std::vector<std::string> names_in(const json& result) {
  std::vector<std::string> names;
  if (!result.is_object()) return names;
  for (const json& unit : result.value("units", json::array()))
    if (unit.is_object() && unit.contains("unit") && unit["unit"].is_string())
      names.push_back(unit["unit"].get<std::string>());
  return names;
}

/// The hosts of units of a farm, by the units.
std::map<std::string, std::string, std::less<>> hosts_in(const json& result) {
  std::map<std::string, std::string, std::less<>> hosts;
  for (const json& unit : result.value("units", json::array()))
    if (unit.is_object() && unit.value("host", json{}).is_string())
      hosts[unit.value("unit", "")] = unit["host"].get<std::string>();
  return hosts;
}

std::string text_of(const std::vector<std::string>& units) {
  if (units.empty()) return "no unit";
  return units.size() == 1 ? units.front() : fmt::format("{} and {} more units", units.front(), units.size() - 1);
}

}  // namespace

Daemons::Daemons(axisd::ServiceEvents& events, std::unique_ptr<Reach> reach, const axisd::Log& log)
    : events_{events}, reach_{std::move(reach)}, log_{log} {
  timer_ = events_.timer(
      [](sd_event_source*, std::uint64_t, void* self) noexcept {
        static_cast<Daemons*>(self)->look();
        return 0;
      },
      this);
  look();
}

/// Whoever still waits is told while there is none that could be found.
Daemons::~Daemons() {
  const std::list<Daemon> last = std::exchange(daemons_, {});
}

void Daemons::look() {
  for (auto daemon = daemons_.begin(); daemon != daemons_.end();) {
    DaemonClient& client = *(daemon++)->client;
    if (!client.is_silent()) continue;
    client.give_up(refuse(Refused::SilentDaemon, fmt::format("{}: the daemon does not answer", client.path())));
    forget(client, "no answer within 10 s");
  }
  if (reach_->do_units_change())
    for (Daemon& daemon : daemons_) ask_for_units(daemon);
  for (const std::string& path : reach_->places()) reach(path);
  axisd::ServiceEvents::start(timer_, kPeriod);
}

/// A socket that nobody serves any more, or not yet, is nothing to speak of unless it was named.
void Daemons::reach(const std::string& path) {
  const auto is_there = [&path](const Daemon& daemon) { return daemon.client->path() == path; };
  if (std::ranges::any_of(daemons_, is_there)) return;
  auto opened = connect(path, *this);
  if (!opened) {
    if (reach_->are_named()) complain(opened.error());
    return;
  }
  Daemon& daemon = daemons_.emplace_back(Daemon{*std::move(opened)});
  if (!reach_->do_units_change()) complaints_.clear();
  ask_for_units(daemon);
  if (wants_events_) subscribe(*daemon.client);
}

tl::expected<std::unique_ptr<DaemonClient>, std::string> Daemons::connect(const std::string& path,
                                                                          DaemonClient::Listener& listener) {
  auto socket = reach_->connect(path);
  if (!socket) return tl::unexpected{std::move(socket.error())};
  return std::make_unique<DaemonClient>(events_, path, *std::move(socket), listener);
}

/// Once for each reason, until another daemon has come.
void Daemons::complain(const std::string& why) {
  if (complaints_.insert(why).second) log_.notice("{}", why);
}

void Daemons::ask_for_units(Daemon& daemon) {
  if (std::exchange(daemon.is_asked, true)) return;
  DaemonClient& client = *daemon.client;
  gateway::ask_for_units(client, [this, &client](const Answer& answer) { take_units(client, answer); });
}

/// A farm whose server is away has no answer; what was subscribed to before is so no more when it is back.
void Daemons::take_units(DaemonClient& client, const Answer& answer) {
  const auto daemon = find(client);
  if (daemon == daemons_.end()) return;
  daemon->is_asked = false;
  if (!answer) {
    if (reach_->do_units_change()) complain(answer.error().message);
    daemon->is_lost = true;
    return;
  }
  if (std::exchange(daemon->is_lost, false)) {
    complaints_.clear();
    if (wants_events_) subscribe(client);
  }
  std::vector<std::string> names = names_in(*answer);
  daemon->hosts = hosts_in(*answer);
  if (std::exchange(daemon->is_known, true) && names == daemon->units) return;
  daemon->units = std::move(names);
  tell_of_units(*daemon);
}

void Daemons::tell_of_units(const Daemon& daemon) {
  const std::string& path = daemon.client->path();
  for (const std::string& unit : daemon.units)
    if (const auto first = find(unit); first && *first != daemon.client.get())
      log_.warning("{}: has a unit {} as {} has, which is reached under this name", path, unit, (*first)->path());
  for (const std::string& unit : daemon.units)
    if (known_.size() < kMostKnown) known_.insert(unit);
  log_.info("{}: {}", path, text_of(daemon.units));
  if (listener_ != nullptr) listener_->on_units();
}

void Daemons::want_events(bool wanted) {
  if (wanted == wants_events_) return;
  wants_events_ = wanted;
  for (const Daemon& daemon : daemons_) subscribe(*daemon.client);
}

/// An answer says nothing more: a daemon that refuses is switched off, and tells nothing.
void Daemons::subscribe(DaemonClient& client) const {
  client.ask(wants_events_ ? "events.subscribe" : "events.unsubscribe", json::object(), [](const Answer&) {});
}

tl::expected<DaemonClient*, Error> Daemons::find(std::string_view unit) const {
  for (const Daemon& daemon : daemons_)
    if (std::ranges::find(daemon.units, unit) != daemon.units.end()) return daemon.client.get();
  if (known_.contains(unit))
    return tl::unexpected{refuse(Refused::NoDaemon, fmt::format("{}: its daemon is gone for the moment", unit))};
  return tl::unexpected{refused_by_daemon(control::ErrorCode::UnknownUnit,
                                          fmt::format("no unit is called {}; GET /api/v1/units lists them", unit),
                                          nullptr)};
}

std::list<Daemons::Daemon>::iterator Daemons::find(const DaemonClient& client) noexcept {
  return std::ranges::find(daemons_, &client, [](const Daemon& each) { return each.client.get(); });
}

std::string Daemons::host_of(std::string_view unit) const {
  for (const Daemon& daemon : daemons_)
    if (const auto host = daemon.hosts.find(unit); host != daemon.hosts.end()) return host->second;
  return {};
}

std::vector<DaemonClient*> Daemons::clients() const {
  std::vector<DaemonClient*> all;
  for (const Daemon& daemon : daemons_) all.push_back(daemon.client.get());
  return all;
}

bool Daemons::are_known() const noexcept {
  return std::ranges::all_of(daemons_, &Daemon::is_known);
}

std::vector<std::string> Daemons::units() const {
  std::vector<std::string> all;
  for (const Daemon& daemon : daemons_) all.insert(all.end(), daemon.units.begin(), daemon.units.end());
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

void Daemons::on_notice(DaemonClient&, std::string_view key, const json& value) {
  if (listener_ != nullptr && key == "event" && value.is_object()) listener_->on_event(value);
}

void Daemons::on_gone(DaemonClient& client, const std::string& why) {
  forget(client, why);
}

void Daemons::forget(DaemonClient& client, const std::string& why) {
  const auto daemon = find(client);
  if (daemon == daemons_.end()) return;
  log_.info("{}: {}: {}", client.path(), text_of(daemon->units), why);
  daemons_.erase(daemon);
  if (listener_ != nullptr) listener_->on_units();
}

}  // namespace gateway
