#include "tools/axisctl/page/page.hpp"

#include <chrono>
#include <ctime>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "control/eds_file.hpp"
#include "tools/axisctl/page/base64.hpp"
#include "version/version.hpp"

namespace axisctl {
namespace {

using nlohmann::json;

constexpr int kVersion = 1;
constexpr std::string_view kPlace{R"(<script type="application/json" id="session">null</script>)"};
constexpr std::string_view kNull{"null"};

json json_of(const PageUnit& unit) {
  json recordings = json::array();
  for (const Recording& recording : unit.recordings)
    recordings.push_back({{"name", recording.name}, {"data", base64(recording.content)}});
  json value{{"unit", unit.unit}, {"resources", unit.resources}, {"recordings", recordings}};
  if (!unit.name.empty()) value["name"] = unit.name;
  if (!unit.eds.empty()) value["eds"] = unit.eds;
  return value;
}

}  // namespace

std::string profile_of(const PageUnit& unit) {
  const json status = unit.resources.value("", json::object());
  const json told = status.is_object() ? status.value("profile", json{}) : json{};
  if (told.is_string()) return told.get<std::string>();
  const std::string recorded = unit.recordings.empty() ? "" : unit.recordings.back().profile();
  return recorded.empty() ? std::string{control::kProfileS120} : recorded;
}

json json_of(const Page& page) {
  json units = json::array();
  for (const PageUnit& unit : page.units) units.push_back(json_of(unit));
  json value{{"format", "axisd-session"}, {"version", kVersion},
             {"title", page.title},       {"made_by", fmt::format("axisctl {}", version::number())},
             {"made_at", page.made_at},   {"units", std::move(units)}};
  if (page.verdict) {
    value["verdict"] = {{"passed", page.verdict->passed}, {"text", page.verdict->text}};
    value["report"] = page.verdict->report;
  }
  return value;
}

std::string script_text(const json& value) {
  const std::string dumped = value.dump(-1, ' ', false, json::error_handler_t::replace);
  std::string text;
  text.reserve(dumped.size() + dumped.size() / 16);
  for (std::size_t at = 0; at < dumped.size();) {
    const std::size_t next = std::min(dumped.find('<', at), dumped.size());
    text.append(dumped, at, next - at);
    if (next < dumped.size()) text += "\\u003c";
    at = next + 1;
  }
  return text;
}

tl::expected<std::string, std::string> fill_page(std::string blank, const Page& page) {
  const std::size_t place = blank.find(kPlace);
  const bool has_one = place != std::string::npos && blank.find(kPlace, place + 1) == std::string::npos;
  if (!has_one) return tl::unexpected{fmt::format("expected {} in it, once", kPlace)};
  blank.replace(place + kPlace.find(kNull), kNull.size(), script_text(json_of(page)));
  return blank;
}

std::string time_of_making() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}Z", fmt::gmtime(std::time(nullptr)));
}

}  // namespace axisctl
