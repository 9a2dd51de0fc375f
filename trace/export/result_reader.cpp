#include "trace/export/result_reader.hpp"

#include <array>
#include <limits>
#include <string_view>

namespace trace {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 3> kParts{"samples", "frames", "events"};

/// JSON has no way to write a number that is none.
double number_of(const json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

Result::Sample sample_of(const json& item) {
  Result::Sample sample{item.at(0).get<double>(), {}};
  for (std::size_t i = 1; i < item.size(); ++i) sample.values.push_back(number_of(item.at(i)));
  return sample;
}

Result::Frame frame_of(const json& item) {
  return {.t = item.at("t").get<double>(),
          .id = item.at("id").get<std::uint32_t>(),
          .sent = item.at("direction") == "sent",
          .extended = item.value("extended", false),
          .remote = item.value("remote", false),
          .data = item.at("data").get<std::string>()};
}

template <class Value>
std::optional<Value> optional_of(const json& item, const char* key) {
  return item.contains(key) ? std::optional{item.at(key).get<Value>()} : std::nullopt;
}

Result::Event event_of(const json& item) {
  const json& place = item.at("axis");
  return {.t = item.at("t").get<double>(),
          .kind = item.at("kind").get<std::string>(),
          .place = place.is_string() ? place.get<std::string>() : place.dump(),
          .text = item.at("text").get<std::string>(),
          .active = item.at("active").get<bool>(),
          .number = optional_of<int>(item, "number"),
          .index = optional_of<int>(item, "index"),
          .value = optional_of<double>(item, "value")};
}

}  // namespace

std::optional<json> ResultReader::next() const {
  if (part_ == kParts.size()) return std::nullopt;
  json params{{"part", kParts[part_]}, {"from", from_}};
  if (number_) params["result"] = *number_;
  return params;
}

bool ResultReader::take_item(const json& item) {
  if (part_ == 1) result_.frames.push_back(frame_of(item));
  if (part_ == 2) result_.events.push_back(event_of(item));
  if (part_ != 0) return true;
  result_.samples.push_back(sample_of(item));
  return result_.samples.back().values.size() == result_.signals.size();
}

/// The library tells by exceptions what is not as it should be; they end here.
tl::expected<void, std::string> ResultReader::take(const json& page) try {
  if (part_ == kParts.size()) return {};
  number_ = page.at("result").get<std::uint64_t>();  // the further pages are of the same one
  if (result_.signals.empty())
    for (const json& signal : page.at("signals"))
      result_.signals.push_back({.name = signal.at("signal").get<std::string>(),
                                 .unit = signal.at("unit").get<std::string>(),
                                 .text = signal.at("text").get<std::string>()});
  result_.trigger = optional_of<double>(page, "trigger_t");
  result_.lost_frames = page.at("lost_frames").get<std::size_t>();
  for (const json& item : page.at("items"))
    if (!take_item(item))
      return tl::unexpected{std::string{"a sample has more or fewer values than there are signals"}};
  if (!page.contains("next")) {
    ++part_;
    from_ = 0;
    return {};
  }
  const json& next = page.at("next");
  if (!next.is_number_integer() || next <= from_ || next > page.at("total"))
    return tl::unexpected{std::string{"the pages of the trace do not go on"}};
  from_ = next.get<std::size_t>();
  return {};
} catch (const json::exception& error) {
  return tl::unexpected{std::string{"no page of a trace: "} + error.what()};
}

}  // namespace trace
