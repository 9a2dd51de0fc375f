#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "daemon/control/arguments.hpp"
#include "daemon/control/handlers.hpp"
#include "daemon/control/trace/trace_view.hpp"
#include "daemon/instance/instance.hpp"
#include "trace/signal/signal.hpp"
#include "trace/signal/signal_list.hpp"

namespace axisd {
namespace {

using nlohmann::json;

constexpr std::int64_t kMostListed = 200;
constexpr std::int64_t kListed = 100;
constexpr std::int64_t kLastSignal = 1'000'000;
constexpr std::size_t kMostRead = 32;

json listed(const trace::ListedSignal& signal) {
  json entry{{"signal", signal.name}, {"unit", signal.unit}, {"text", signal.text}};
  if (signal.indices > 1) entry["indices"] = signal.indices;
  if (signal.bits > 0) entry["bits"] = signal.bits;
  return entry;
}

Outcome list_signals(const Call& call, const json& params) {
  const Arguments arguments{params};
  const auto text = arguments.text("search", "");
  if (!text) return tl::unexpected{text.error()};
  const auto asked = arguments.page({.last = kLastSignal, .most = kMostListed, .usual = kListed});
  if (!asked) return tl::unexpected{asked.error()};
  const trace::SignalPage page = trace::list_signals(std::as_const(call.instance).device().unit(),
                                                     {.text = *text, .from = asked->from, .count = asked->count});
  json signals = json::array();
  for (const trace::ListedSignal& signal : page.signals) signals.push_back(listed(signal));
  json result{{"signals", std::move(signals)}, {"total", page.total}};
  const auto next = asked->from + page.signals.size();
  if (next < page.total) result["next"] = next;
  return result;
}

Outcome read_signals(const Call& call, const json& params) {
  const std::string expected = fmt::format("a list of 1 to {} names of signals", kMostRead);
  const json* const given = Arguments{params}.find("signals");
  const json one = given != nullptr && given->is_string() ? json::array({*given}) : json{};
  const json* const names = one.is_array() ? &one : given;
  const bool is_list = names != nullptr && names->is_array() && !names->empty() && names->size() <= kMostRead;
  if (!is_list) return tl::unexpected{unexpected_value("signals", expected, names)};
  json signals = json::array();
  for (const json& name : *names) {
    if (!name.is_string()) return tl::unexpected{unexpected_value("signals", expected, names)};
    auto found =
        trace::find_signal(std::as_const(call.instance).device().unit(), name.get_ref<const std::string&>());
    if (!found) {
      found.error().key = fmt::format("signals[{}]", signals.size());
      return tl::unexpected{error_of(found.error())};
    }
    signals.push_back({{"signal", found->name}, {"unit", found->unit}, {"value", found->reader.value()}});
  }
  return json{{"t", seconds_since_start(call.instance, device::unit_time(call.now))},
              {"signals", std::move(signals)}};
}

constexpr std::array kSignalHandlers{
    Handler{"signal.list", &list_signals},
    Handler{"signal.read", &read_signals},
};

}  // namespace

std::span<const Handler> signal_handlers() noexcept {
  return kSignalHandlers;
}

}  // namespace axisd
