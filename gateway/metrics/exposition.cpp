#include "gateway/metrics/exposition.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "gateway/metrics/families.hpp"

namespace gateway {
namespace {

using nlohmann::json;

/// Labels of a sample, in their order.
using Labels = std::vector<std::pair<std::string_view, std::string>>;

constexpr std::array<std::string_view, 3> kTypeNames{"counter", "gauge", "histogram"};
constexpr std::array<std::string_view, 4> kNmtStates{"Initialising", "Pre-operational", "Operational", "Stopped"};
constexpr std::array<std::string_view, 4> kBusStates{"error-active", "error-warning", "error-passive", "bus-off"};
constexpr std::array<std::string_view, 10> kDriveStates{
    "Not ready to switch on", "Switch on disabled", "Ready to switch on",    "Switched on", "Operation enabled",
    "OFF1 braking",           "Quick stop active",  "Fault reaction active", "STOP2",       "Fault"};

/// A label's value as the format wants it.
std::string escaped(std::string_view text) {
  std::string written;
  for (const char character : text) {
    if (character == '\n') {
      written += "\\n";
      continue;
    }
    if (character == '\\' || character == '"') written += '\\';
    written += character;
  }
  return written;
}

/// The member of @p object at @p pointer; null if there is none.
const json& at(const json& object, std::string_view pointer) {
  static const json kNothing;
  const json::json_pointer place{std::string{pointer}};
  return object.is_structured() && object.contains(place) ? object.at(place) : kNothing;
}

std::string text_of(const json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// The samples of one family.
class Samples {
 public:
  explicit Samples(const Family& family) : family_{family} {}

  void add(const Labels& labels, const json& value, std::string_view suffix = "") {
    if (!value.is_number()) return;
    fmt::format_to(std::back_inserter(text_), "{}{}{{", family_.name, suffix);
    for (std::size_t i = 0; i < labels.size(); ++i)
      fmt::format_to(std::back_inserter(text_), "{}{}=\"{}\"", i == 0 ? "" : ",", labels[i].first,
                     escaped(labels[i].second));
    fmt::format_to(std::back_inserter(text_), "}} {}\n", value.dump());
  }

  /// A sample a state, 1 for @p present.
  void add_states(Labels labels, std::span<const std::string_view> states, const json& present) {
    if (!present.is_string()) return;
    labels.emplace_back("state", "");
    for (const std::string_view state : states) {
      labels.back().second = state;
      add(labels, present.get_ref<const std::string&>() == state ? 1 : 0);
    }
  }

  /// @p histogram as `metrics` gives it, whose classes do not contain each other.
  void add_histogram(Labels labels, const json& histogram) {
    const json& bounds = at(histogram, "/bounds");
    const json& counts = at(histogram, "/counts");
    if (!bounds.is_array() || !counts.is_array() || counts.size() != bounds.size() + 1) return;
    labels.emplace_back("le", "");
    std::uint64_t below = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      if (!counts[i].is_number_unsigned()) return;
      below += counts[i].get<std::uint64_t>();
      labels.back().second = i < bounds.size() ? bounds[i].dump() : "+Inf";
      add(labels, below, "_bucket");
    }
    labels.pop_back();
    add(labels, at(histogram, "/sum"), "_sum");
    add(labels, below, "_count");
  }

  /// With its head; nothing without samples.
  std::string text() const {
    if (text_.empty()) return {};
    return fmt::format("# HELP {0} {1}\n# TYPE {0} {2}\n{3}", family_.name, family_.help,
                       kTypeNames[static_cast<std::size_t>(family_.type)], text_);
  }

 private:
  const Family& family_;
  std::string text_{};
};

bool answers(const UnitSample& sample) {
  return sample.status.is_object();
}

void add_up(Samples& samples, const UnitSample& sample) {
  samples.add({{"unit", sample.unit}}, answers(sample) ? 1 : 0);
}

void add_info(Samples& samples, const UnitSample& sample) {
  if (!answers(sample)) return;
  Labels labels{{"unit", sample.unit},
                {"interface", text_of(at(sample.status, "/interface"))},
                {"node_id", text_of(at(sample.status, "/node_id"))},
                {"version", text_of(at(sample.status, "/version"))}};
  if (!sample.host.empty()) labels.emplace_back("host", sample.host);
  samples.add(labels, 1);
}

void add_nmt_state(Samples& samples, const UnitSample& sample) {
  samples.add_states({{"unit", sample.unit}}, kNmtStates, at(sample.status, "/nmt_state"));
}

void add_bus_state(Samples& samples, const UnitSample& sample) {
  samples.add_states({{"unit", sample.unit}}, kBusStates, at(sample.status, "/bus/state"));
}

void add_link(Samples& samples, const UnitSample& sample) {
  const json& link = at(sample.status, "/bus/link");
  if (link.is_string()) samples.add({{"unit", sample.unit}}, link == "up" ? 1 : 0);
}

/// Frames that are no aborts are `ok`.
void add_sdo_frames(Samples& samples, const UnitSample& sample) {
  for (const json& server : at(sample.metrics, "/sdo")) {
    const json& frames = at(server, "/frames");
    if (!frames.is_number_unsigned()) continue;
    const Labels labels{{"unit", sample.unit}, {"server", text_of(at(server, "/server"))}, {"result", "ok"}};
    std::uint64_t aborts = 0;
    for (const json& abort : at(server, "/aborts"))
      if (const json& count = at(abort, "/count"); count.is_number_unsigned())
        aborts += count.get<std::uint64_t>();
    samples.add(labels, frames.get<std::uint64_t>() - std::min(aborts, frames.get<std::uint64_t>()));
    for (const json& abort : at(server, "/aborts")) {
      Labels of_code = labels;
      of_code.back().second = text_of(at(abort, "/code"));
      samples.add(of_code, at(abort, "/count"));
    }
  }
}

void add_messages(Samples& samples, const UnitSample& sample) {
  for (const json& message : at(sample.metrics, "/messages"))
    samples.add({{"unit", sample.unit},
                 {"drive_object", text_of(at(message, "/drive_object"))},
                 {"kind", text_of(at(message, "/kind"))},
                 {"code", text_of(at(message, "/code"))}},
                at(message, "/count"));
}

/// Of the control unit (axis 0), the infeed and the axes.
void add_active(Samples& samples, const UnitSample& sample) {
  const auto add = [&](const std::string& axis, const json& place) {
    for (const auto& [kind, member] : {std::pair{"fault", "/faults"}, std::pair{"alarm", "/alarms"}})
      if (const json& list = at(place, member); list.is_array())
        samples.add({{"unit", sample.unit}, {"axis", axis}, {"kind", kind}}, list.size());
  };
  add("0", at(sample.status, "/control_unit"));
  add("infeed", at(sample.status, "/infeed"));
  for (const json& axis : at(sample.status, "/axes")) add(text_of(at(axis, "/axis")), axis);
}

Labels labels_of(const UnitSample& sample, const json& axis) {
  return {{"unit", sample.unit}, {"axis", text_of(at(axis, "/axis"))}, {"name", text_of(at(axis, "/name"))}};
}

void add_axis_states(Samples& samples, const UnitSample& sample) {
  for (const json& axis : at(sample.status, "/axes"))
    samples.add_states(labels_of(sample, axis), kDriveStates, at(axis, "/state"));
}

/// Families that are more than a number at a place.
struct SpecialRow {
  std::string_view family;
  void (*add)(Samples& samples, const UnitSample& sample);
};
constexpr std::array kSpecialRows{
    SpecialRow{family::kUp, &add_up},
    SpecialRow{family::kInfo, &add_info},
    SpecialRow{family::kNmtState, &add_nmt_state},
    SpecialRow{family::kLinkUp, &add_link},
    SpecialRow{family::kBusState, &add_bus_state},
    SpecialRow{family::kSdoFrames, &add_sdo_frames},
    SpecialRow{family::kMessages, &add_messages},
    SpecialRow{family::kActive, &add_active},
    SpecialRow{family::kAxisState, &add_axis_states},
};
static_assert(std::ranges::all_of(kFamilies, [](const Family& family) {
  return (family.source == Source::Special) ==
         (std::ranges::find(kSpecialRows, family.name, &SpecialRow::family) != kSpecialRows.end());
}));

/// A number or histogram of the unit.
void add_value(Samples& samples, const UnitSample& sample, const Family& family) {
  constexpr std::string_view kStatus = "/status";
  constexpr std::string_view kMetrics = "/metrics";
  const bool of_status = family.pointer.starts_with(kStatus);
  const json& value = at(of_status ? sample.status : sample.metrics,
                         family.pointer.substr((of_status ? kStatus : kMetrics).size()));
  if (family.type == MetricType::Histogram) return samples.add_histogram({{"unit", sample.unit}}, value);
  samples.add({{"unit", sample.unit}}, value);
}

void add(Samples& samples, const UnitSample& sample, const Family& family) {
  if (family.source == Source::Special)
    return std::ranges::find(kSpecialRows, family.name, &SpecialRow::family)->add(samples, sample);
  if (family.source == Source::Unit) return add_value(samples, sample, family);
  for (const json& axis : at(sample.status, "/axes"))
    samples.add(labels_of(sample, axis), at(axis, family.pointer));
}

}  // namespace

std::string exposition(std::span<const UnitSample> units) {
  std::string text;
  for (const Family& family : kFamilies) {
    Samples samples{family};
    for (const UnitSample& unit : units) add(samples, unit, family);
    text += samples.text();
  }
  return text;
}

}  // namespace gateway
