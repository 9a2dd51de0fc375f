#include "tools/axisctl/scenario/run/actions.hpp"

#include <algorithm>
#include <array>
#include <csignal>

#include <fmt/format.h>

#include "libcanopen/base/nmt_state.hpp"
#include "tools/axisctl/scenario/language/frame_pattern.hpp"
#include "tools/axisctl/scenario/run/fault_load.hpp"
#include "tools/axisctl/scenario/run/observation.hpp"
#include "tools/axisctl/scenario/run/sdo_steps.hpp"

namespace scenario {
namespace {

using nlohmann::json;

constexpr const char* kBusIsDown = "the frame could not be sent: the bus is down, or nobody takes its frames";

tl::unexpected<std::string> fail(std::string text) {
  return tl::unexpected{std::move(text)};
}

/// @p answer without what it has brought.
Outcome done(const tl::expected<json, std::string>& answer) {
  if (!answer) return fail(answer.error());
  return std::string{};
}

Outcome send(Context& context, const json& keys) {
  const canopen::Frame frame = *parse_frame(keys.at("send").get<std::string>());
  for (int left = keys.value("times", 1); left > 0; --left)
    if (!context.bench.send(frame)) return fail(kBusIsDown);
  return std::string{};
}

Outcome start_cyclic(Context& context, const json& keys) {
  context.bench.start_cyclic(keys.at("as"), *parse_frame(keys.at("cyclic").get<std::string>()),
                             milliseconds(keys.at("every_ms")));
  return std::string{};
}

Outcome stop_cyclic(Context& context, const json& keys) {
  context.bench.stop_cyclic(keys.at("stop"));
  return std::string{};
}

struct NmtWord {
  std::string_view word;
  canopen::NmtCommand command;
};
constexpr std::array kNmtWords{NmtWord{"start", canopen::NmtCommand::Start},
                               NmtWord{"stop", canopen::NmtCommand::Stop},
                               NmtWord{"pre-operational", canopen::NmtCommand::EnterPreOperational},
                               NmtWord{"reset-node", canopen::NmtCommand::ResetNode},
                               NmtWord{"reset-communication", canopen::NmtCommand::ResetCommunication}};

Outcome command(Context& context, const json& keys) {
  const auto word = std::ranges::find(kNmtWords, keys.at("nmt").get<std::string>(), &NmtWord::word);
  canopen::Frame frame{.id = 0, .length = 2};
  frame.data = {static_cast<std::uint8_t>(word->command), context.stations.unit(keys).plan.node_id};
  if (!context.bench.send(frame)) return fail(kBusIsDown);
  return std::string{};
}

Outcome set(Context& context, const json& keys) {
  return done(ask(context.stations.unit(keys), "parameter.write",
                  {{"parameter", keys.at("set")}, {"value", keys.at("value")}}));
}

/// The way to Operation enabled (CiA 402): controlword in the first RPDO of the axis, and the state it leads to.
struct Station {
  std::uint8_t controlword;
  const char* state;
};
constexpr std::array kWay{Station{6, "ready-to-switch-on"}, Station{7, "switched-on"},
                          Station{15, "operation-enabled"}};

/// Identifier of the first RPDO with the controlword of @p axis.
tl::expected<std::uint32_t, std::string> controlword_of(Unit& unit, int axis) {
  const auto told = ask(unit, "pdo.list");
  if (!told) return tl::unexpected{told.error()};
  for (const json& pdo : told->value("pdos", json::array()))
    if (pdo.value("direction", "") == "receive" && pdo.value("axis", 0) == axis && pdo.value("is_valid", false) &&
        pdo.value("/mapping/0/name"_json_pointer, "") == "Controlword" && pdo.value("length", 0) == 2)
      return pdo.value("identifier", 0U);
  return tl::unexpected{fmt::format("no RPDO has the controlword of axis {} alone", axis)};
}

Outcome turn_on(Context& context, const json& keys) {
  const int axis = keys.at("turn_on");
  Unit& unit = context.stations.unit(keys);
  const auto identifier = controlword_of(unit, axis);
  if (!identifier) return fail(identifier.error());
  for (const Station& station : kWay) {
    canopen::Frame frame{.id = *identifier, .length = 2};
    frame.data[0] = station.controlword;
    if (!context.bench.send(frame)) return fail(kBusIsDown);
    const json condition{{"drive_state", station.state}, {"axis", axis}, {"unit", unit.plan.name}};
    const Outcome reached =
        wait_for(context, condition_of(condition), milliseconds(keys.value("within_ms", kUsualWait)));
    if (!reached) return fail(fmt::format("controlword {}: {}", station.controlword, reached.error()));
  }
  return std::string{};
}

Outcome inject(Context& context, const json& keys) {
  const auto fault = load_fault(context, keys, keys.at("inject"));
  if (!fault) return fail(fault.error());
  if (keys.contains("as")) context.faults[keys.at("as")] = *fault;
  return fmt::format("fault {}", fault->id);
}

Outcome take_back(Context& context, const json& keys) {
  if (const auto taken = take_back_fault(context, keys.at("remove")); !taken) return fail(taken.error());
  return std::string{};
}

Outcome switch_power(Context& context, const json& keys) {
  return done(ask(context.stations.unit(keys), keys.at("power") == "on" ? "unit.on" : "unit.off"));
}

/// Whether each member of @p wanted is in @p result, and so of objects below.
bool has_all(const json& result, const json& wanted) {
  if (!wanted.is_object()) return result == wanted;
  if (!result.is_object()) return false;
  const auto items = wanted.items();
  return std::all_of(items.begin(), items.end(), [&result](const auto& item) {
    return result.contains(item.key()) && has_all(result[item.key()], item.value());
  });
}

Outcome call(Context& context, const json& keys) {
  const auto result = ask(context.stations.unit(keys), keys.at("call").get_ref<const std::string&>(),
                          keys.value("params", json::object()));
  if (keys.value("refused", false)) {
    if (!result) return result.error();
    return fail("expected a refusal, got " + result->dump());
  }
  if (!result) return fail(result.error());
  if (keys.contains("result") && !has_all(*result, keys.at("result")))
    return fail(fmt::format("expected {}, got {}", keys.at("result").dump(), result->dump()));
  return std::string{};
}

Outcome let_time_pass(Context& context, const json& keys) {
  context.bench.pass(context.bench.now() + milliseconds(keys.at("wait_ms")));
  return std::string{};
}

Outcome expect(Context& context, const json& keys) {
  return wait_for(context, condition_of(keys.at("expect")), milliseconds(keys.value("within_ms", kUsualWait)));
}

Outcome start_program(Context& context, const json& keys) {
  Program& program = context.stations.program(keys.at("start"));
  if (const auto started = context.stations.start(program); !started) return fail(started.error());
  return std::string{};
}

struct Signal {
  std::string_view word;
  int number;
};
constexpr std::array kSignals{Signal{"KILL", SIGKILL}, Signal{"TERM", SIGTERM}, Signal{"STOP", SIGSTOP},
                              Signal{"CONT", SIGCONT}};

Outcome signal_program(Context& context, const json& keys) {
  const Program& program = context.stations.program(keys.at("kill"));
  if (!program.process) return fail("the program has not been started");
  const auto signal = std::ranges::find(kSignals, keys.value("signal", std::string{"KILL"}), &Signal::word);
  program.process->signal(signal->number);
  return std::string{};
}

/// What a row of actions() does.
struct ActionRow {
  std::string_view action;
  Outcome (*act)(Context& context, const json& keys);
  /// An acting step: later expectations look at frames from its beginning on; a pause: from its end on.
  enum class Mark : std::uint8_t { Begin, End, Keep } mark = Mark::Begin;
};
constexpr std::array kActionRows{ActionRow{"send", send},
                                 ActionRow{"cyclic", start_cyclic},
                                 ActionRow{"stop", stop_cyclic},
                                 ActionRow{"nmt", command},
                                 ActionRow{"read", read_entry},
                                 ActionRow{"write", write_entry},
                                 ActionRow{"set", set},
                                 ActionRow{"turn_on", turn_on},
                                 ActionRow{"inject", inject},
                                 ActionRow{"remove", take_back},
                                 ActionRow{"power", switch_power},
                                 ActionRow{"call", call},
                                 ActionRow{"wait_ms", let_time_pass, ActionRow::Mark::End},
                                 ActionRow{"expect", expect, ActionRow::Mark::Keep},
                                 ActionRow{"start", start_program},
                                 ActionRow{"kill", signal_program}};

}  // namespace

canopen::Duration milliseconds(double milliseconds) noexcept {
  return std::chrono::duration_cast<canopen::Duration>(std::chrono::duration<double, std::milli>{milliseconds});
}

Outcome wait_for(Context& context, const Condition& condition, canopen::Duration limit) {
  Observation observation{condition, context.mark};
  const canopen::TimePoint begin = context.bench.now(), until = begin + limit;
  while (true) {
    const bool is_last = context.bench.now() >= until;
    const auto holds = observation.holds(context);
    if (!holds) return fail(holds.error());
    if (*holds) break;
    if (is_last || context.bench.interrupted())
      return fail(fmt::format("not within {} ms, there is {}",
                              std::chrono::duration_cast<std::chrono::milliseconds>(limit).count(),
                              observation.found()));
    context.bench.wait(until);
  }
  context.mark = observation.behind().value_or(context.mark);
  return observation.found();
}

Outcome act(Context& context, const Step& step) {
  const auto row = std::ranges::find(kActionRows, step.action->key.key, &ActionRow::action);
  const std::size_t begin = context.bench.frames().size();
  if (row->mark == ActionRow::Mark::Begin) context.mark = begin;
  Outcome outcome = row->act(context, step.keys);
  if (row->mark == ActionRow::Mark::End) context.mark = context.bench.frames().size();
  return outcome;
}

}  // namespace scenario
