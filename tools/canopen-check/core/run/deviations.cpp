#include "tools/canopen-check/core/run/deviations.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "text/number.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

std::optional<unsigned> parse_hexadecimal(std::string_view text, unsigned most) {
  const auto value = text::integer<unsigned>(text, 16);
  return value <= most ? value : std::nullopt;
}

struct Bounds {
  unsigned first, last;
};

/// "1400h-15C7h" or "1400h" with @p suffix "h"; "02-52" or "02" without.
std::optional<Bounds> parse_bounds(std::string_view text, std::string_view suffix, unsigned most) {
  const std::size_t dash = text.find('-');
  const auto part = [&](std::string_view piece) -> std::optional<unsigned> {
    if (!piece.ends_with(suffix)) return std::nullopt;
    piece.remove_suffix(suffix.size());
    return parse_hexadecimal(piece, most);
  };
  const std::optional<unsigned> first = part(text.substr(0, dash));
  const std::optional<unsigned> last = dash == std::string_view::npos ? first : part(text.substr(dash + 1));
  if (!first || !last || *last < *first) return std::nullopt;
  return Bounds{*first, *last};
}

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

std::optional<ObjectRange> parse_range(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::optional<Bounds> index = parse_bounds(text.substr(0, colon), "h", 0xFFFF);
  std::optional<Bounds> sub = Bounds{0, 0xFF};
  if (colon != std::string_view::npos) sub = parse_bounds(text.substr(colon + 1), "", 0xFF);
  if (!index || !sub) return std::nullopt;
  return ObjectRange{static_cast<std::uint16_t>(index->first), static_cast<std::uint16_t>(index->last),
                     static_cast<std::uint8_t>(sub->first), static_cast<std::uint8_t>(sub->last)};
}

/// The text of @p key in @p item, which has to have one.
tl::expected<std::string, std::string> text_of(const nlohmann::json& item, const char* key, std::size_t position) {
  const auto at = item.find(key);
  if (at != item.end() && at->is_string() && !at->get_ref<const std::string&>().empty())
    return at->get<std::string>();
  return tl::unexpected{
      fmt::format("/{}/{}: expected a text, got {}", position, key, at == item.end() ? "nothing" : at->dump())};
}

tl::expected<Deviation, std::string> parse_deviation(const nlohmann::json& item, std::size_t position) {
  if (!item.is_object())
    return tl::unexpected{fmt::format("/{}: expected an object, got {}", position, item.dump())};
  Deviation deviation;
  for (const auto& [key, member] : {std::pair{"check", &Deviation::check}, std::pair{"reason", &Deviation::reason},
                                    std::pair{"source", &Deviation::source}}) {
    tl::expected<std::string, std::string> text = text_of(item, key, position);
    if (!text) return tl::unexpected{text.error()};
    deviation.*member = std::move(*text);
  }
  if (item.contains("object")) {
    const tl::expected<std::string, std::string> text = text_of(item, "object", position);
    if (!text) return tl::unexpected{text.error()};
    std::optional<std::vector<ObjectRange>> objects = parse_objects(*text);
    if (!objects)
      return tl::unexpected{
          fmt::format("/{}/object: expected objects such as \"1400h-15C7h:02\", got \"{}\"", position, *text)};
    deviation.objects = std::move(*objects);
  }
  return deviation;
}

}  // namespace

bool ObjectRange::contains(const Subject& subject) const noexcept {
  if (!subject.index) return false;
  std::uint16_t index = *subject.index;
  if (first >= kFirstAxis && first < kFirstAxis + kAxisDistance && index >= kFirstAxis + kAxisDistance &&
      index < kEndOfAxes)
    index = static_cast<std::uint16_t>(kFirstAxis + (index - kFirstAxis) % kAxisDistance);
  if (index < first || index > last) return false;
  return !subject.sub_index || (*subject.sub_index >= first_sub && *subject.sub_index <= last_sub);
}

std::optional<std::vector<ObjectRange>> parse_objects(std::string_view text) {
  std::vector<ObjectRange> ranges;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::optional<ObjectRange> range = parse_range(trimmed(text.substr(begin, end - begin)));
    if (!range) return std::nullopt;
    ranges.push_back(*range);
    begin = end + 1;
  }
  return ranges;
}

bool Deviation::covers(const Finding& finding) const noexcept {
  return objects.empty() ||
         std::ranges::any_of(objects, [&](const ObjectRange& range) { return range.contains(finding.subject); });
}

tl::expected<Deviations, std::string> Deviations::parse(std::string_view text) {
  const nlohmann::json list = nlohmann::json::parse(text, nullptr, false);
  if (!list.is_array()) return tl::unexpected{std::string{"expected a JSON list of {check, reason, source}"}};
  Deviations deviations;
  for (std::size_t position = 0; position < list.size(); ++position) {
    tl::expected<Deviation, std::string> deviation = parse_deviation(list[position], position);
    if (!deviation) return tl::unexpected{deviation.error()};
    deviations.all_.push_back(std::move(*deviation));
  }
  return deviations;
}

void Deviations::judge(CheckResult& result) {
  if (result.outcome == Outcome::Skipped || result.outcome == Outcome::Broken) return;
  std::vector<Finding> unseen;
  for (Deviation& deviation : all_) {
    if (deviation.check != result.check->id) continue;
    for (Finding& finding : result.findings)
      if (deviation.covers(finding)) {
        finding.deviation = deviation.reason;
        deviation.seen = true;
      }
    if (!deviation.seen)
      unseen.push_back({.expected = "the known deviation: " + deviation.reason, .found = "no such finding"});
  }
  std::ranges::move(unseen, std::back_inserter(result.findings));
  if (result.findings.empty()) return;
  const bool all_known = std::ranges::none_of(result.findings, &std::string::empty, &Finding::deviation);
  result.outcome = all_known ? Outcome::Deviates : Outcome::Failed;
}

}  // namespace conformance
