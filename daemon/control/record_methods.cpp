// The recording of a unit: start, stop, status.
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "daemon/control/arguments.hpp"
#include "daemon/control/handlers.hpp"
#include "daemon/instance/instance.hpp"

namespace axisd {
namespace {

using nlohmann::json;
using Limits = RecordSettings::Limits;

json status_of(const std::optional<UnitRecording::Status>& status) {
  if (!status) return {{"state", "off"}};
  const auto& [settings, recorder] = *status;
  json told{{"state", name_of(recorder.state)},
            {"name", settings.name},
            {"on_fault", settings.on_fault},
            {"signals", settings.signals},
            {"file", recorder.files.file},
            {"files", recorder.files.files},
            {"bytes", recorder.files.bytes},
            {"records", recorder.files.records},
            {"lost", recorder.lost + recorder.files.unwritten}};
  if (settings.on_fault) told["faults"] = recorder.faults;
  if (!recorder.files.error.empty()) told["error"] = recorder.files.error;
  return told;
}

Outcome show_status(const Call& call, const json&) {
  return status_of(call.instance.recording().status());
}

/// The names of the signals, one alone without a list; absent: none.
Taken<std::vector<std::string>> signals_in(const Arguments& arguments) {
  std::vector<std::string> signals;
  const json* const list = arguments.find("signals");
  if (list == nullptr) return signals;
  if (list->is_string()) return std::vector{list->get<std::string>()};
  const std::string expected = fmt::format("at most {} names of signals", RecordSettings::kMostSignals);
  if (!list->is_array() || list->size() > RecordSettings::kMostSignals)
    return tl::unexpected{unexpected_value("signals", expected, list)};
  for (const json& name : *list) {
    if (!name.is_string()) return tl::unexpected{unexpected_value("signals", expected, list)};
    signals.push_back(name.get<std::string>());
  }
  return signals;
}

/// A number of the settings, which stays if @p key is absent.
struct NumberKey {
  const char* key;
  Limits limits;
  double RecordSettings::*member;
};
constexpr std::array kNumbers{NumberKey{"max_MB", RecordSettings::kSize, &RecordSettings::most_MB},
                              NumberKey{"before_s", RecordSettings::kBefore, &RecordSettings::before},
                              NumberKey{"after_s", RecordSettings::kAfter, &RecordSettings::after}};

Taken<RecordSettings> settings_in(const Arguments& arguments) {
  RecordSettings settings;
  const auto name = arguments.text("name", settings.name);
  if (!name) return tl::unexpected{name.error()};
  if (!name->empty() && !record::is_name(*name))
    return tl::unexpected{unexpected_value("name", "1 to 64 letters, digits, '_', '-' or '.', a dot not in front",
                                           arguments.find("name"))};
  settings.name = *name;
  auto signals = signals_in(arguments);
  if (!signals) return tl::unexpected{signals.error()};
  settings.signals = *std::move(signals);
  const auto on_fault = arguments.flag("on_fault", settings.on_fault);
  if (!on_fault) return tl::unexpected{on_fault.error()};
  settings.on_fault = *on_fault;
  for (const NumberKey& row : kNumbers) {
    const auto number = arguments.number(row.key, row.limits.low, row.limits.high, settings.*row.member);
    if (!number) return tl::unexpected{number.error()};
    settings.*row.member = *number;
  }
  if (!arguments.has("every_s")) return settings;
  const auto period =
      arguments.number("every_s", RecordSettings::kPeriod.low, RecordSettings::kPeriod.high, std::nullopt);
  if (!period) return tl::unexpected{period.error()};
  settings.period = *period;
  return settings;
}

constexpr control::ErrorCode code_of(UnitRecording::Refusal::Why why) noexcept {
  using enum UnitRecording::Refusal::Why;
  switch (why) {
    case NoSuchSignal:
      return control::ErrorCode::NotFound;
    case Busy:
      return control::ErrorCode::Busy;
    case NoThread:
      break;
  }
  return control::ErrorCode::Refused;
}

Outcome start(const Call& call, const json& params) {
  const auto settings = settings_in(Arguments{params});
  if (!settings) return tl::unexpected{settings.error()};
  const auto begun = call.instance.recording().start(*settings, call.now);
  if (!begun) return refuse(code_of(begun.error().why), begun.error().message);
  return status_of(call.instance.recording().status());
}

Outcome stop(const Call& call, const json&) {
  call.instance.recording().stop(call.now);
  return status_of(call.instance.recording().status());
}

constexpr std::array kRecordHandlers{
    Handler{"record.start", &start},
    Handler{"record.stop", &stop},
    Handler{"record.status", &show_status},
};

}  // namespace

std::span<const Handler> record_handlers() noexcept {
  return kRecordHandlers;
}

}  // namespace axisd
