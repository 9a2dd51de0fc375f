#include "daemon/server/dispatcher.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <sys/epoll.h>

#include "control/methods.hpp"
#include "control/request_check.hpp"
#include "control/units_page.hpp"
#include "daemon/control/events/carry_out.hpp"
#include "daemon/control/handlers.hpp"
#include "json/strict.hpp"
#include "service/clock.hpp"

namespace axisd {
namespace {

using control::ErrorCode;
using nlohmann::json;

std::string names_of_methods() {
  std::string names;
  for (const control::Method& method : control::kMethods)
    names.append(names.empty() ? "" : ", ").append(method.name);
  return names;
}

json entry_of(const ServedUnit& unit) {
  return {{"unit", unit.name()},
          {"interface", unit.configuration().address.text},
          {"node_id", unit.configuration().node_id},
          {"profile", name_of(unit.configuration().profile())},
          {"axes", unit.configuration().axes.size()},
          {"on", unit.instance() != nullptr}};
}

}  // namespace

Dispatcher::Dispatcher(ServiceEvents& events, ControlSocket socket, Fleet& fleet, EventQueue& queue,
                       std::function<void()> on_quit)
    : fleet_{fleet},
      on_quit_{std::move(on_quit)},
      mail_{events.watch(mailbox_.descriptor(), EPOLLIN, &Dispatcher::on_mail, this)},
      server_{events, std::move(socket), *this},
      subscriptions_{events, fleet, queue, server_,
                     [this](ServedUnit& unit, UnitJob job, std::function<void(Outcome)> done) {
                       run(unit, std::move(job), std::move(done));
                     }} {}

int Dispatcher::on_mail(sd_event_source*, int, std::uint32_t, void* self) noexcept {
  static_cast<Dispatcher*>(self)->mailbox_.do_one();
  return 0;
}

void Dispatcher::on_request(ClientId client, std::string_view line) {
  auto request = control::parse_request(line);
  if (!request) return server_.answer(client, control::error_line(request.error().id, request.error().error));
  dispatch({client, *std::move(request)});
}

void Dispatcher::dispatch(Asked asked) {
  if (const auto outcome = carry_out(asked)) answer(asked, *outcome);
}

void Dispatcher::answer(const Asked& asked, const Outcome& outcome) {
  const json& id = asked.request.id;
  server_.answer(asked.client,
                 outcome ? control::result_line(id, *outcome) : control::error_line(id, outcome.error()));
}

std::optional<Outcome> Dispatcher::carry_out(Asked& asked) {
  control::Request& request = asked.request;
  const control::Method* const method = control::find_method(request.method);
  if (method == nullptr)
    return refuse(ErrorCode::UnknownMethod, fmt::format("method: expected one of {}, got {}", names_of_methods(),
                                                        json_text::quote(request.method)));
  const ProgramHandler* const program = find_program_handler(method->name);
  const Handler* const handler = find_handler(method->name);
  const auto name = control::take_unit(request.params);
  if (!name) return refuse(ErrorCode::BadParameter, name.error());
  const Needs needs = program == nullptr ? Needs::One : program->unit;
  tl::expected<ServedUnit*, control::Error> unit = nullptr;
  if (needs == Needs::One || (needs == Needs::OneOrAll && !name->empty())) unit = fleet_.find(*name);
  if (!unit) return tl::unexpected{unit.error()};
  const std::size_t axes = *unit == nullptr ? 0 : (*unit)->configuration().axes.size();
  if (const auto checked = control::check(*method, request.params, axes); !checked)
    return refuse(ErrorCode::BadParameter, checked.error());
  if (program != nullptr) return (this->*program->answer)(asked, *unit);
  if (handler == nullptr) return refuse(ErrorCode::UnknownMethod, "method: not of this daemon");
  return call_unit(asked, **unit, *handler);
}

std::optional<Outcome> Dispatcher::call_unit(const Asked& asked, ServedUnit& unit, const Handler& handler) {
  run(
      unit,
      [&handler, params = asked.request.params](const Call& call) {
        return axisd::carry_out(handler, call, params);
      },
      [this, asked](const Outcome& outcome) { answer(asked, outcome); });
  return std::nullopt;
}

/// On the thread of the unit, whose outcome comes back as mail.
void Dispatcher::run(ServedUnit& unit, UnitJob job, std::function<void(Outcome)> done) {
  Instance* const instance = unit.instance();
  if (instance == nullptr)
    return done(refuse(ErrorCode::Off, fmt::format("{} is switched off: switch it on (unit.on)", unit.name())));
  unit.loop().post(
      [this, instance, job = std::move(job), done = std::move(done)] {
        auto outcome = std::make_shared<Outcome>(job({*instance, read_clock()}));
        mailbox_.post([done, outcome] { done(std::move(*outcome)); });
      },
      instance);
}

std::optional<Outcome> Dispatcher::list_units(const Asked& asked, ServedUnit*) {
  std::vector<const ServedUnit*> units;
  for (const ServedUnit& unit : fleet_.units()) units.push_back(&unit);
  json result = control::units_page(asked.request.params.value("from", std::size_t{0}), units.size(),
                                    [&units](std::size_t at) { return entry_of(*units[at]); });
  result.update({{"clients", server_.clients()},
                 {"refused_clients", server_.counters().refused},
                 {"cut_off_clients", server_.counters().cut_off},
                 {"lost_events", subscriptions_.lost_events()}});
  return result;
}

std::optional<Outcome> Dispatcher::switch_unit_off(const Asked& asked, ServedUnit* unit) {
  if (unit->instance() == nullptr) return json::object();
  Instance* const instance = &unit->begin_to_switch_off();
  unit->loop().post([this, unit, instance, asked] {
    unit->loop().remove(*instance);
    mailbox_.post([this, unit, asked] {
      unit->switch_off();
      answer(asked, json::object());
    });
  });
  return std::nullopt;
}

std::optional<Outcome> Dispatcher::switch_unit_on(const Asked& asked, ServedUnit* unit) {
  if (unit->instance() != nullptr) return json::object();
  if (!unit->is_off()) return refuse(ErrorCode::Busy, fmt::format("{} is being switched off", unit->name()));
  try {
    unit->switch_on();
  } catch (const std::exception& reason) {
    return refuse(ErrorCode::Refused, reason.what());
  }
  Instance* const instance = unit->instance();
  subscriptions_.take_up(*unit, *instance);
  unit->loop().post(
      [this, unit, instance, asked] {
        unit->loop().add(*instance);
        instance->start();
        mailbox_.post([this, asked] { answer(asked, json::object()); });
      },
      instance);
  return std::nullopt;
}

std::optional<Outcome> Dispatcher::subscribe_to_events(const Asked& asked, ServedUnit* unit) {
  return subscriptions_.subscribe_to_events(asked.client, unit, asked.request.params);
}

std::optional<Outcome> Dispatcher::end_events(const Asked& asked, ServedUnit*) {
  subscriptions_.end_events(asked.client);
  return json::object();
}

std::optional<Outcome> Dispatcher::subscribe_to_samples(const Asked& asked, ServedUnit* unit) {
  subscriptions_.subscribe_to_samples(asked.client, *unit, asked.request.params,
                                      [this, asked](const Outcome& outcome) { answer(asked, outcome); });
  return std::nullopt;
}

std::optional<Outcome> Dispatcher::end_samples(const Asked& asked, ServedUnit*) {
  subscriptions_.end_samples(asked.client);
  return json::object();
}

std::optional<Outcome> Dispatcher::subscribe_to_frames(const Asked& asked, ServedUnit* unit) {
  subscriptions_.subscribe_to_frames(asked.client, *unit,
                                     [this, asked](const Outcome& outcome) { answer(asked, outcome); });
  return std::nullopt;
}

std::optional<Outcome> Dispatcher::end_frames(const Asked& asked, ServedUnit*) {
  subscriptions_.end_frames(asked.client);
  return json::object();
}

std::optional<Outcome> Dispatcher::quit(const Asked&, ServedUnit*) {
  on_quit_();
  return json::object();
}

const Dispatcher::ProgramHandler* Dispatcher::find_program_handler(std::string_view method) noexcept {
  static constexpr std::array kHandlers{
      ProgramHandler{"units", Needs::None, &Dispatcher::list_units},
      ProgramHandler{"unit.off", Needs::One, &Dispatcher::switch_unit_off},
      ProgramHandler{"unit.on", Needs::One, &Dispatcher::switch_unit_on},
      ProgramHandler{"events.subscribe", Needs::OneOrAll, &Dispatcher::subscribe_to_events},
      ProgramHandler{"events.unsubscribe", Needs::None, &Dispatcher::end_events},
      ProgramHandler{"samples.subscribe", Needs::One, &Dispatcher::subscribe_to_samples},
      ProgramHandler{"samples.unsubscribe", Needs::None, &Dispatcher::end_samples},
      ProgramHandler{"frames.subscribe", Needs::One, &Dispatcher::subscribe_to_frames},
      ProgramHandler{"frames.unsubscribe", Needs::None, &Dispatcher::end_frames},
      ProgramHandler{"quit", Needs::None, &Dispatcher::quit},
  };
  const auto* const row = std::ranges::find(kHandlers, method, &ProgramHandler::method);
  return row == kHandlers.end() ? nullptr : row;
}

}  // namespace axisd
