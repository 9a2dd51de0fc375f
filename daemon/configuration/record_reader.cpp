#include "daemon/configuration/record_reader.hpp"

namespace axisd {
namespace {

double number_in(const JsonReader& json, RecordSettings::Limits limits) {
  return json.number(limits.low, limits.high);
}

}  // namespace

RecordSettings read_record(const JsonReader& json) {
  json.expect_object({"name", "max_MB", "signals", "every_s", "on_fault", "before_s", "after_s"});
  RecordSettings settings;
  if (json.has("name")) {
    settings.name = json.at("name").text();
    if (!record::is_name(settings.name))
      json.at("name").fail("1 to 64 letters, digits, '_', '-' or '.', a dot not in front");
  }
  if (json.has("max_MB")) settings.most_MB = number_in(json.at("max_MB"), RecordSettings::kSize);
  if (json.has("signals")) {
    const JsonReader signals = json.at("signals");
    signals.expect_array(0, RecordSettings::kMostSignals);
    for (std::size_t i = 0; i < signals.size(); ++i) settings.signals.push_back(signals.at(i).text());
  }
  if (json.has("every_s")) settings.period = number_in(json.at("every_s"), RecordSettings::kPeriod);
  if (json.has("on_fault")) settings.on_fault = json.at("on_fault").boolean();
  if (json.has("before_s")) settings.before = number_in(json.at("before_s"), RecordSettings::kBefore);
  if (json.has("after_s")) settings.after = number_in(json.at("after_s"), RecordSettings::kAfter);
  return settings;
}

}  // namespace axisd
