#include "audit/base/findings.hpp"

namespace audit {

void Findings::explain(Finding& finding, const meaning::CobIds& ids) {
  for (const Heard& heard : finding.evidence)
    finding.meanings.push_back(heard.is_error ? meaning::Meaning{} : ids.meaning_of(heard.frame));
}

std::uint64_t Findings::count(const Rule& rule, std::uint8_t node) const noexcept {
  const auto found = counts_.find({&rule, node});
  return found == counts_.end() ? 0 : found->second;
}

std::uint64_t Findings::count(const Rule& rule) const noexcept {
  std::uint64_t sum = 0;
  for (auto at = counts_.lower_bound({&rule, 0}); at != counts_.end() && at->first.first == &rule; ++at)
    sum += at->second;
  return sum;
}

std::uint64_t Findings::count(Severity severity) const noexcept {
  std::uint64_t sum = 0;
  for (const auto& [key, count] : counts_)
    if (key.first->severity == severity) sum += count;
  return sum;
}

}  // namespace audit
