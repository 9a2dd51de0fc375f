#include "farm/documents/settings.hpp"

#include "farm/documents/field_reader.hpp"

namespace farm {
namespace {

constexpr std::uint32_t kLowestRate = 1000;
constexpr std::uint32_t kHighestRate = 1'000'000;

}  // namespace

tl::expected<BusSettings, std::string> parse_bus_settings(std::string_view key, std::string_view text) {
  FieldReader fields{key, text};
  fields.allow_only({"bitrate"});
  const auto rate = static_cast<std::uint32_t>(fields.number("bitrate", 0, kHighestRate, 0));
  if (rate != 0 && rate < kLowestRate) fields.fail("bitrate", "0, or 1000 to 1000000", rate);
  return fields.result(BusSettings{rate});
}

tl::expected<HostSettings, std::string> parse_host_settings(std::string_view key, std::string_view text) {
  FieldReader fields{key, text};
  fields.allow_only({"drain"});
  return fields.result(HostSettings{fields.flag("drain", false)});
}

std::string text_of(const BusSettings& settings) {
  return nlohmann::json{{"bitrate", settings.bit_rate}}.dump();
}

std::string text_of(const HostSettings& settings) {
  return nlohmann::json{{"drain", settings.drain}}.dump();
}

}  // namespace farm
