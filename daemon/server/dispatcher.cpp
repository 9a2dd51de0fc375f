#include "daemon/server/dispatcher.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <sys/epoll.h>

#include "control/methods.hpp"
#include "control/request_check.hpp"
#include "daemon/base/clock.hpp"
#include "daemon/control/handlers.hpp"

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

/// The unit that @p params name, as text; it is taken out of them.
tl::expected<std::string, control::Error> take_unit(json& params) {
  const auto unit = params.find("unit");
  if (unit == params.end()) return {};
  const json value = *unit;
  params.erase(unit);
  if (value.is_string() && !value.get_ref<const std::string&>().empty()) return value.get<std::string>();
  if (value.is_number_integer()) return value.dump();
  return refuse(ErrorCode::BadParameter,
                fmt::format("unit: expected a node-ID or BUS/NODE, got {}", value.dump()));
}

}  // namespace

Dispatcher::Dispatcher(ServiceEvents& events, std::string path, Fleet& fleet, std::function<void()> on_quit)
    : fleet_{fleet},
      on_quit_{std::move(on_quit)},
      mail_{events.watch(mailbox_.descriptor(), EPOLLIN, &Dispatcher::on_mail, this)},
      server_{events, std::move(path), *this} {}

int Dispatcher::on_mail(sd_event_source*, int, std::uint32_t, void* self) noexcept {
  static_cast<Dispatcher*>(self)->mailbox_.do_one();
  return 0;
}

void Dispatcher::on_request(ClientId client, std::string_view line) {
  auto request = control::parse_request(line);
  if (!request) return server_.answer(client, control::error_line(request.error().id, request.error().message));
  dispatch({client, *std::move(request)});
}

void Dispatcher::dispatch(Asked asked) {
  if (const auto outcome = carry_out(asked)) answer(asked, *outcome);
}

void Dispatcher::answer(const Asked& asked, const Outcome& outcome) {
  const json& id = asked.request.id;
  server_.answer(asked.client,
                 outcome ? control::result_line(id, *outcome) : control::error_line(id, outcome.error().message));
}

std::optional<Outcome> Dispatcher::carry_out(Asked& asked) {
  const control::Method* const method = control::find_method(asked.request.method);
  if (method == nullptr)
    return refuse(ErrorCode::UnknownMethod,
                  fmt::format("method: expected one of {}, got \"{}\"", names_of_methods(), asked.request.method));
  if (const ProgramHandler* const handler = find_program_handler(method->name))
    return (this->*handler->answer)(asked);
  const Handler* const handler = find_handler(method->name);
  if (handler == nullptr) return refuse(ErrorCode::UnknownMethod, "method: not of this daemon");
  return ask_unit(asked, *method, *handler);
}

/// On the thread of the unit, whose result comes back as mail.
std::optional<Outcome> Dispatcher::ask_unit(Asked& asked, const control::Method& method, const Handler& handler) {
  const auto name = take_unit(asked.request.params);
  if (!name) return tl::unexpected{name.error()};
  const auto unit = fleet_.find(*name);
  if (!unit) return tl::unexpected{unit.error()};
  const auto checked = control::check(method, asked.request.params, (*unit)->configuration().axes.size());
  if (!checked) return refuse(ErrorCode::BadParameter, checked.error());
  Instance* const instance = (*unit)->instance();
  if (instance == nullptr)
    return refuse(ErrorCode::Off, fmt::format("{} is switched off: switch it on (unit.on)", (*unit)->name()));
  (*unit)->loop().post(
      [this, instance, &handler, asked = std::make_shared<Asked>(std::move(asked))] {
        auto outcome = std::make_shared<Outcome>(handler.answer({*instance, read_clock()}, asked->request.params));
        mailbox_.post([this, asked, outcome] { answer(*asked, *outcome); });
      },
      instance);
  return std::nullopt;
}

std::optional<Outcome> Dispatcher::list_units(const Asked&) {
  json units = json::array();
  for (const ServedUnit& unit : fleet_.units())
    units.push_back({{"unit", unit.name()},
                     {"interface", unit.configuration().address.text},
                     {"node_id", unit.configuration().node_id},
                     {"axes", unit.configuration().axes.size()},
                     {"on", unit.instance() != nullptr}});
  return json{{"units", std::move(units)},
              {"clients", server_.clients()},
              {"refused_clients", server_.counters().refused},
              {"cut_off_clients", server_.counters().cut_off}};
}

std::optional<Outcome> Dispatcher::switch_unit_off(const Asked& asked) {
  json params = asked.request.params;
  const auto name = take_unit(params);
  if (!name) return tl::unexpected{name.error()};
  const auto found = fleet_.find(*name);
  if (!found) return tl::unexpected{found.error()};
  ServedUnit* const unit = *found;
  if (unit->instance() == nullptr) return json::object();
  Instance* const instance = &unit->begin_to_switch_off();
  unit->loop().post([this, unit, instance, asked = std::make_shared<Asked>(asked)] {
    unit->loop().remove(*instance);
    mailbox_.post([this, unit, asked] {
      unit->switch_off();
      answer(*asked, json::object());
    });
  });
  return std::nullopt;
}

std::optional<Outcome> Dispatcher::switch_unit_on(const Asked& asked) {
  json params = asked.request.params;
  const auto name = take_unit(params);
  if (!name) return tl::unexpected{name.error()};
  const auto found = fleet_.find(*name);
  if (!found) return tl::unexpected{found.error()};
  ServedUnit* const unit = *found;
  if (unit->instance() != nullptr) return json::object();
  if (!unit->is_off()) return refuse(ErrorCode::Busy, fmt::format("{} is being switched off", unit->name()));
  try {
    unit->switch_on();
  } catch (const std::exception& reason) {
    return refuse(ErrorCode::Refused, reason.what());
  }
  Instance* const instance = unit->instance();
  unit->loop().post(
      [this, unit, instance, asked = std::make_shared<Asked>(asked)] {
        unit->loop().add(*instance);
        instance->start();
        mailbox_.post([this, asked] { answer(*asked, json::object()); });
      },
      instance);
  return std::nullopt;
}

std::optional<Outcome> Dispatcher::quit(const Asked&) {
  on_quit_();
  return json::object();
}

const Dispatcher::ProgramHandler* Dispatcher::find_program_handler(std::string_view method) noexcept {
  static constexpr std::array kHandlers{
      ProgramHandler{"units", &Dispatcher::list_units},
      ProgramHandler{"unit.off", &Dispatcher::switch_unit_off},
      ProgramHandler{"unit.on", &Dispatcher::switch_unit_on},
      ProgramHandler{"quit", &Dispatcher::quit},
  };
  const auto* const row = std::ranges::find(kHandlers, method, &ProgramHandler::method);
  return row == kHandlers.end() ? nullptr : row;
}

}  // namespace axisd
