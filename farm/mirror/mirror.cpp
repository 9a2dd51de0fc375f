#include "farm/mirror/mirror.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "control/methods.hpp"
#include "control/request_check.hpp"
#include "control/units_page.hpp"
#include "farm/naming/subjects.hpp"
#include "os/clock.hpp"

namespace farm {
namespace {

using control::ErrorCode;
using nlohmann::json;

constexpr std::chrono::milliseconds kTick{100};
constexpr std::size_t kMostNamed = 8;  ///< units in a message

json entry_of(const Directory::Entry& entry) {
  const DoorUnit& unit = entry.unit;
  return {{"unit", unit.name.text()}, {"interface", unit.name.bus}, {"node_id", unit.node_id},
          {"profile", unit.profile},  {"axes", unit.axes},          {"on", unit.is_on},
          {"host", entry.host}};
}

/// Names of @p units for a message, not all of many.
std::string names_of(const std::vector<Directory::Entry>& units) {
  std::vector<std::string> names;
  for (const Directory::Entry& entry : units)
    if (names.size() < kMostNamed) names.push_back(entry.unit.name.text());
  const std::size_t more = units.size() - names.size();
  return fmt::format("{}{}", fmt::join(names, ", "), more == 0 ? "" : fmt::format(" and {} more", more));
}

/// The kinds of events that @p params, which have the form, name; or what is wrong with one of them.
tl::expected<std::vector<std::string>, std::string> kinds_of(const json& params) {
  std::vector<std::string> kinds;
  const auto named = params.find("kinds");
  if (named == params.end()) return kinds;
  for (const json& kind : *named) {
    if (std::ranges::none_of(control::kEventKind, [&kind](std::string_view known) { return kind == known; }))
      return tl::unexpected{fmt::format("kinds: expected some of {}, got {}", fmt::join(control::kEventKind, ", "),
                                        kind.dump(-1, ' ', true))};
    kinds.push_back(kind.get<std::string>());
  }
  return kinds;
}

}  // namespace

Mirror::Mirror(axisd::ServiceEvents& events, Messages& messages, std::string farm, std::string place,
               const MirrorTimes& times)
    : messages_{messages},
      farm_{std::move(farm)},
      place_{std::move(place)},
      times_{times},
      begun_{os::monotonic_time()},
      directory_{times.silence},
      settling_{times.quiet, times.longest},
      connections_{events, *this},
      requests_{messages, farm_, times.answer},
      events_{messages, connections_, farm_},
      deliveries_{events, messages, requests_, connections_, times.keep} {
  messages_.subscribe(all_doors_subject(farm_), [this](const Message& message) { take_beat(message); });
  tick_ = events.timer(
      [](sd_event_source*, std::uint64_t, void* self) noexcept {
        static_cast<Mirror*>(self)->tick();
        return 0;
      },
      this);
  axisd::ServiceEvents::start(tick_, kTick);
}

Mirror::~Mirror() {
  messages_.unsubscribe(all_doors_subject(farm_));
}

void Mirror::on_up() {
  contact_ = Contact::Up;
  settling_.begin(os::monotonic_time());
  messages_.publish(who_subject(farm_), "{}");
  retry();
}

void Mirror::on_down(const std::string& why) {
  contact_ = Contact::Down;
  why_down_ = fmt::format("{}: {}", place_, why);
  events_.give_up(unreachable(why_down_));
  deliveries_.give_up(unreachable(why_down_));
  retry();
}

void Mirror::when_in_contact(std::function<void(tl::expected<void, std::string>)> then) {
  wait([this, then = std::move(then)] {
    if (contact_ == Contact::Unknown) return false;
    then(contact_ == Contact::Up ? tl::expected<void, std::string>{} : tl::unexpected{why_down_});
    return true;
  });
}

void Mirror::take_beat(const Message& message) {
  const auto beat = parse_door_beat(message.subject, message.data);
  const Instant now = os::monotonic_time();
  if (!beat || !directory_.take(*beat, now)) return;
  settling_.take_new(now);
  retry();
}

void Mirror::tick() {
  axisd::ServiceEvents::start(tick_, kTick);
  const Instant now = os::monotonic_time();
  if (contact_ == Contact::Unknown && now - begun_ > times_.longest)
    on_down(fmt::format("no answer within {} s", std::chrono::duration<double>{times_.longest}.count()));
  if (contact_ == Contact::Up)
    for (const std::string& host : directory_.take_silent(now)) {
      requests_.give_up(host);
      deliveries_.give_up(host);
    }
  retry();
}

bool Mirror::is_settled() const noexcept {
  const auto due = settling_.due();
  return due && *due <= os::monotonic_time();
}

void Mirror::wait(Waiting waiting) {
  if (!waiting()) waiting_.push_back(std::move(waiting));
}

void Mirror::retry() {
  for (Waiting& waiting : std::exchange(waiting_, {})) wait(std::move(waiting));
}

void Mirror::on_line(const Ticket& ticket, std::string_view line) {
  auto request = control::parse_request(line);
  if (!request) return connections_.answer(ticket, control::error_line(request.error().id, request.error().error));
  wait([this, ticket, request = *std::move(request)] {
    return !connections_.has(ticket.client) || answer(ticket, request);
  });
}

void Mirror::on_gone(Connections::Id client) {
  events_.end(client);
  deliveries_.forget(client);
}

/// False: it has to wait.
bool Mirror::answer(const Ticket& ticket, const Request& asked) {
  if (contact_ == Contact::Unknown) return false;
  if (contact_ == Contact::Down) return refuse(ticket, asked, unreachable(why_down_)), true;
  Request request = asked;
  const auto name = control::take_unit(request.params);
  if (!name) return refuse(ticket, request, {ErrorCode::BadParameter, name.error()}), true;
  const OwnMethod* const own = find_own(request.method);
  const Needs needs = own == nullptr ? Needs::One : own->unit;
  const bool means_one = needs == Needs::One || (needs == Needs::OneOrAll && !name->empty());
  if (!means_one && own->needs_all_known && !is_settled()) return false;
  const Meant unit = means_one ? unit_called(*name) : Meant{Directory::Entry{}};
  if (!unit) return false;
  if (!*unit) return refuse(ticket, request, unit->error()), true;
  const auto answer = own == nullptr ? &Mirror::ask_unit : own->answer;
  (this->*answer)(ticket, request, means_one ? &**unit : nullptr);
  return true;
}

Mirror::Meant Mirror::unit_called(std::string_view name) const {
  const auto unit = parse_unit_name(name);
  if (!unit) return is_settled() ? Meant{unit_among_all(name)} : std::nullopt;
  auto found = directory_.find(*unit, os::monotonic_time());
  if (found) return *std::move(found);
  if (!is_settled()) return std::nullopt;
  return tl::unexpected{absent(*unit, found.error())};
}

tl::expected<Directory::Entry, control::Error> Mirror::unit_among_all(std::string_view name) const {
  std::vector<Directory::Entry> units = directory_.units(os::monotonic_time());
  if (!name.empty())
    std::erase_if(units, [name](const Directory::Entry& entry) { return entry.unit.name.node != name; });
  if (units.size() == 1) return std::move(units.front());
  const std::string got = name.empty() ? "nothing" : fmt::format("\"{}\"", name);
  if (units.empty())
    return tl::unexpected{control::Error{ErrorCode::UnknownUnit,
                                         fmt::format("unit: expected a unit of farm {}, got {}", farm_, got)}};
  return tl::unexpected{control::Error{ErrorCode::UnknownUnit,
                                       fmt::format("unit: expected one of {}, got {}", names_of(units), got)}};
}

control::Error Mirror::absent(const UnitName& name, const Absence& absence) const {
  if (absence.host.empty())
    return {ErrorCode::UnknownUnit,
            fmt::format("unit: expected a unit of farm {}, got \"{}\"", farm_, name.text())};
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(absence.silent_for).count();
  return unreachable(
      fmt::format("{}: host {}, where it was, has been silent for {} s", name.text(), absence.host, seconds));
}

void Mirror::refuse(const Ticket& ticket, const Request& request, const control::Error& why) {
  connections_.answer(ticket, control::error_line(request.id, why));
}

void Mirror::ask_unit(const Ticket& ticket, const Request& request, const Directory::Entry* unit) {
  requests_.ask({.unit = *unit, .id = request.id, .method = request.method, .params = request.params},
                [this, ticket](std::string line) { connections_.answer(ticket, std::move(line)); });
}

void Mirror::list_units(const Ticket& ticket, const Request& request, const Directory::Entry* unit) {
  const auto units = unit != nullptr ? std::vector{*unit} : directory_.units(os::monotonic_time());
  const auto* const method = control::find_method(request.method);
  if (const auto checked = control::check(*method, request.params, 0); !checked)
    return refuse(ticket, request, {ErrorCode::BadParameter, checked.error()});
  json result = control::units_page(request.params.value("from", std::size_t{0}), units.size(),
                                    [&units](std::size_t at) { return entry_of(units[at]); });
  result.update({{"clients", connections_.size()},
                 {"refused_clients", 0},
                 {"cut_off_clients", connections_.cut_off()},
                 {"lost_events", events_.strange()}});
  connections_.answer(ticket, control::result_line(request.id, result));
}

void Mirror::subscribe_to_events(const Ticket& ticket, const Request& request, const Directory::Entry* unit) {
  const auto* const method = control::find_method(request.method);
  const auto kinds =
      control::check(*method, request.params, 0).and_then([&request] { return kinds_of(request.params); });
  if (!kinds) return refuse(ticket, request, {ErrorCode::BadParameter, kinds.error()});
  EventRelay::Filter filter{.kinds = *kinds};
  if (unit != nullptr) filter.unit = unit->unit.name;
  events_.subscribe(ticket.client, std::move(filter));
  connections_.answer(ticket, control::result_line(request.id, json::object()));
}

void Mirror::end_events(const Ticket& ticket, const Request& request, const Directory::Entry*) {
  events_.end(ticket.client);
  connections_.answer(ticket, control::result_line(request.id, json::object()));
}

void Mirror::subscribe_to_stream(const Ticket& ticket, const Request& request, const Directory::Entry* unit) {
  deliveries_.subscribe(ticket.client,
                        {.unit = *unit, .id = request.id, .method = request.method, .params = request.params},
                        [this, ticket](std::string line) { connections_.answer(ticket, std::move(line)); });
}

void Mirror::end_stream(const Ticket& ticket, const Request& request, const Directory::Entry*) {
  deliveries_.end(ticket.client, request.method.substr(0, request.method.find('.')));
  connections_.answer(ticket, control::result_line(request.id, json::object()));
}

void Mirror::refuse_to_quit(const Ticket& ticket, const Request& request, const Directory::Entry*) {
  refuse(ticket, request,
         {ErrorCode::Refused, "quit: a farm is not ended; units that are wanted no more are removed"});
}

const Mirror::OwnMethod* Mirror::find_own(std::string_view method) noexcept {
  static constexpr std::array kOwn{
      OwnMethod{"units", Needs::OneOrAll, true, &Mirror::list_units},
      OwnMethod{"events.subscribe", Needs::OneOrAll, false, &Mirror::subscribe_to_events},
      OwnMethod{"events.unsubscribe", Needs::None, false, &Mirror::end_events},
      OwnMethod{"samples.subscribe", Needs::One, false, &Mirror::subscribe_to_stream},
      OwnMethod{"samples.unsubscribe", Needs::None, false, &Mirror::end_stream},
      OwnMethod{"frames.subscribe", Needs::One, false, &Mirror::subscribe_to_stream},
      OwnMethod{"frames.unsubscribe", Needs::None, false, &Mirror::end_stream},
      OwnMethod{"quit", Needs::None, false, &Mirror::refuse_to_quit},
  };
  const auto* const row = std::ranges::find(kOwn, method, &OwnMethod::name);
  return row == kOwn.end() ? nullptr : row;
}

}  // namespace farm
