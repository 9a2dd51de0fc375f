#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "control/methods.hpp"
#include "tools/axisctl/commands/command.hpp"
#include "tools/axisctl/commands/comparison.hpp"

namespace axisctl {
namespace {

using nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPause{20};

/// What is waited for. A program of an option of CLI11 fills it.
struct Wish {
  double limit = 0.0;  ///< s; 0: none
  std::string axis{};
  std::string state{};
  std::string number{};
  std::string signal{};
  std::string comparison{};
  std::string value{};
};

/// Whether it has come true, as the unit says now.
using Test = std::function<Expected<bool>(Session& session, const Wish& wish)>;

/// Letters and digits alone, so that "operation-enabled" is "Operation enabled".
std::string essence(std::string_view text) {
  std::string result;
  for (const char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

template <class Names>
Expected<std::string> name_in(const Names& names, const std::string& word) {
  const auto row = std::ranges::find(names, essence(word), essence);
  if (row != names.end()) return std::string{*row};
  return fail(ExitStatus::Usage,
              fmt::format("STATE: expected one of {}, got \"{}\"", fmt::join(names, ", "), word));
}

/// The member of the status that AXIS means: an axis, or the control unit.
Expected<json> place_in(const json& status, const std::string& axis) {
  if (axis == "0") return status.value("control_unit", json::object());
  if (axis == "infeed") return status.value("infeed", json::object());
  for (const json& entry : status.value("axes", json::array()))
    if (entry.value("axis", json{}).dump() == axis) return entry;
  return fail(ExitStatus::NotThere, fmt::format("AXIS: the unit has no axis {}", axis));
}

Expected<bool> is_ready(Session& session, const Wish&) {
  const auto status = session.ask("status");
  if (!status) return tl::unexpected{status.error()};
  return status->value("nmt_state", "Initialising") != "Initialising" &&
         status->value("/bus/link"_json_pointer, "down") == "up";
}

Expected<bool> has_nmt_state(Session& session, const Wish& wish) {
  const auto wanted = name_in(control::kNmtState, wish.state);
  if (!wanted) return tl::unexpected{wanted.error()};
  const auto status = session.ask("status");
  if (!status) return tl::unexpected{status.error()};
  return status->value("nmt_state", "") == *wanted;
}

Expected<bool> has_state(Session& session, const Wish& wish) {
  const auto wanted = name_in(control::kDriveState, wish.state);
  if (!wanted) return tl::unexpected{wanted.error()};
  const auto status = session.ask("status");
  if (!status) return tl::unexpected{status.error()};
  const auto place = place_in(*status, wish.axis);
  if (!place) return tl::unexpected{place.error()};
  return place->value("state", "") == *wanted;
}

/// Faults at AXIS; those of the whole unit without one.
Expected<json> faults_at(Session& session, const Wish& wish) {
  const auto status = session.ask("status");
  if (!status) return tl::unexpected{status.error()};
  json faults = json::array();
  const auto add = [&faults](const json& place) {
    for (const json& fault : place.value("faults", json::array())) faults.push_back(fault.value("number", json{}));
  };
  if (!wish.axis.empty()) {
    const auto place = place_in(*status, wish.axis);
    if (!place) return tl::unexpected{place.error()};
    add(*place);
    return faults;
  }
  add(status->value("control_unit", json::object()));
  add(status->value("infeed", json::object()));
  for (const json& axis : status->value("axes", json::array())) add(axis);
  return faults;
}

Expected<bool> has_fault(Session& session, const Wish& wish) {
  std::string digits = wish.number.substr(wish.number.find_first_not_of("Ff0") == std::string::npos
                                              ? wish.number.size()
                                              : wish.number.find_first_not_of("Ff0"));
  if (digits.find_first_not_of("0123456789") != std::string::npos || (digits.empty() && !wish.number.empty()))
    return fail(ExitStatus::Usage,
                fmt::format("NUMBER: expected a number such as 7860 or F07860, got \"{}\"", wish.number));
  const auto faults = faults_at(session, wish);
  if (!faults) return tl::unexpected{faults.error()};
  if (digits.empty()) return !faults->empty();
  return std::ranges::any_of(*faults, [&digits](const json& number) { return number.dump() == digits; });
}

Expected<bool> has_no_fault(Session& session, const Wish& wish) {
  const auto faults = faults_at(session, wish);
  if (!faults) return tl::unexpected{faults.error()};
  return faults->empty();
}

Expected<bool> has_value(Session& session, const Wish& wish) {
  const auto comparison = parse_comparison(wish.comparison, wish.value);
  if (!comparison) return tl::unexpected{comparison.error()};
  const auto value = read_signal(session, wish.signal);
  if (!value) return tl::unexpected{value.error()};
  return comparison->holds(*value);
}

/// A thing to wait for: its words on the command line, and its test.
struct Condition {
  std::string_view name;
  std::string_view summary;
  void (*add_words)(CLI::App& app, Wish& wish);
  Expected<bool> (*test)(Session& session, const Wish& wish);
};

void add_axis(CLI::App& app, Wish& wish, bool required) {
  app.add_option(
         "AXIS", wish.axis,
         required ? "Axis, 1.., or infeed" : "Axis, 1.., 0 for the control unit, or infeed; all if not given")
      ->required(required)
      ->type_name("");
}

constexpr std::array kConditions{
    Condition{"ready",
              "The unit has sent its boot-up and its bus is up; a daemon that does not run yet is waited for",
              [](CLI::App&, Wish&) {}, is_ready},
    Condition{"nmt", "An NMT state of the node",
              [](CLI::App& app, Wish& wish) {
                app.add_option("STATE", wish.state, "operational, pre-operational or stopped")
                    ->required()
                    ->type_name("");
              },
              has_nmt_state},
    Condition{"state", "A state of a drive (CiA 402)",
              [](CLI::App& app, Wish& wish) {
                add_axis(app, wish, true);
                app.add_option("STATE", wish.state, "operation-enabled, fault, switch-on-disabled, ...")
                    ->required()
                    ->type_name("");
              },
              has_state},
    Condition{"fault", "A fault",
              [](CLI::App& app, Wish& wish) {
                add_axis(app, wish, false);
                app.add_option("NUMBER", wish.number, "Fault, as 7860 or F07860; any if not given")->type_name("");
              },
              has_fault},
    Condition{"no-fault", "No fault any more", [](CLI::App& app, Wish& wish) { add_axis(app, wish, false); },
              has_no_fault},
    Condition{
        "value", "A signal or parameter that compares with a number",
        [](CLI::App& app, Wish& wish) {
          app.add_option("SIGNAL", wish.signal, "As 1/speed, 1/r0063 or p1120")->required()->type_name("");
          app.add_option("COMPARISON", wish.comparison, "lt, le, eq, ne, ge or gt")->required()->type_name("");
          app.add_option("VALUE", wish.value, "Number")->required()->type_name("");
        },
        has_value},
};

Expected<void> wait_for(const Condition& condition, const Settings& settings, const Wish& wish) {
  const auto end =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>{wish.limit});
  const bool may_come_up = condition.test == is_ready;
  std::optional<Session> session;
  while (true) {
    std::optional<Failure> failure;
    if (!session) {
      auto opened = Session::open(settings);
      if (opened)
        session.emplace(*std::move(opened));
      else
        failure = opened.error();
    }
    if (session) {
      const auto holds = condition.test(*session, wish);
      if (holds && *holds) return {};
      if (!holds) failure = holds.error();
    }
    if (failure) session.reset();
    const bool is_away = failure && (failure->status == ExitStatus::NotReachable ||
                                     failure->status == ExitStatus::CutOff || failure->status == ExitStatus::Off);
    if (failure && !(may_come_up && is_away)) return tl::unexpected{*failure};
    if (wish.limit > 0 && Clock::now() >= end)
      return fail(ExitStatus::TimedOut, fmt::format("it has not come true within {} s{}", wish.limit,
                                                    failure ? ": " + failure->message : std::string{}));
    std::this_thread::sleep_for(kPause);
  }
}

}  // namespace

void add_wait(CLI::App& app, Run& run) {
  CLI::App& group = subcommand(app, "wait", "Wait until something holds");
  group.require_subcommand(1);
  for (const Condition& condition : kConditions) {
    CLI::App& sub = subcommand(group, condition.name, condition.summary);
    const auto wish = std::make_shared<Wish>();
    condition.add_words(sub, *wish);
    sub.add_option("--timeout", wish->limit, "Longest time (s); without it there is no limit")
        ->check(CLI::PositiveNumber)
        ->type_name("S");
    sub.callback([&run, &condition, wish] {
      run = [&condition, wish](const Settings& settings) { return wait_for(condition, settings, *wish); };
    });
  }
}

}  // namespace axisctl
