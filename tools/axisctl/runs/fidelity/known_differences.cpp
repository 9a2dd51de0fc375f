#include "tools/axisctl/runs/fidelity/known_differences.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace runs {

using nlohmann::json;

tl::expected<KnownDifferences, std::string> KnownDifferences::parse(std::string_view text) {
  const json list = json::parse(text, nullptr, false);
  if (!list.is_array()) return tl::unexpected{std::string{"expected a JSON list of known differences"}};
  KnownDifferences known;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto text_at = [&item = list[i]](const char* key) {
      const auto found = item.is_object() ? item.find(key) : item.end();
      return item.is_object() && found != item.end() && found->is_string() ? found->get<std::string>()
                                                                           : std::string{};
    };
    const auto nature = std::ranges::find(kNatures, text_at("difference"));
    auto objects = conformance::parse_objects(text_at("object"));
    if (nature == kNatures.end() || !objects || text_at("id").empty() || text_at("reason").empty())
      return tl::unexpected{fmt::format("/{}: expected id, difference ({}), object and reason, got {}", i,
                                        fmt::join(kNatures, ", "), list[i].dump())};
    known.rows_.push_back({static_cast<Nature>(nature - kNatures.begin()), *std::move(objects),
                           fmt::format("{}: {}", text_at("id"), text_at("reason"))});
  }
  return known;
}

std::string KnownDifferences::reason_of(const Finding& finding) const {
  if (!finding.object) return "";
  const conformance::Subject subject{finding.object->index, finding.object->sub_index};
  for (const Row& row : rows_)
    if (row.nature == finding.nature &&
        std::ranges::any_of(row.objects, [&](const auto& range) { return range.contains(subject); }))
      return row.reason;
  return "";
}

}  // namespace runs
