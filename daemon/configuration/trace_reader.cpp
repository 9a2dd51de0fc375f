#include "daemon/configuration/trace_reader.hpp"

#include <algorithm>

#include "trace/json/settings_reader.hpp"

namespace axisd {

trace::Settings read_trace(const JsonReader& json) {
  json.expect_object(trace::settings_keys());
  for (const std::string& key : json.keys())
    if (json.at(key).value().is_null()) json.at(key).fail("a value");
  auto settings = trace::read_settings(json.value());
  if (settings) return std::move(*settings);
  std::string path = settings.error().key;
  std::ranges::replace(path, '.', '/');
  json.fail_below(path, settings.error().expected);
}

}  // namespace axisd
