#include "tools/canopen-check/core/run/entry_values.hpp"

namespace conformance {

EntryValues not_seen_in(SdoClient& sdo, const EntryValues& wanted) {
  constexpr std::size_t kExpedited = 4;
  std::vector<Multiplexor> asked;
  for (const auto& [entry, value] : wanted)
    if (value.size() <= kExpedited) asked.push_back({entry.first, entry.second});
  EntryValues left = wanted;
  const auto frames = sdo.ask_together(asked);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const auto now = frames[i] ? whole_answer(*frames[i]) : std::nullopt;
    const auto at = left.find({asked[i].index, asked[i].sub_index});
    if (now && now->done() && now->data == at->second) left.erase(at);
  }
  return left;
}

}  // namespace conformance
