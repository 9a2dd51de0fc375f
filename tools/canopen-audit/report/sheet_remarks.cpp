#include "tools/canopen-audit/report/sheet_remarks.hpp"

#include <fmt/format.h>

#include "meaning/words.hpp"

namespace audit_tool {
namespace {

std::string misfit_text(const audit::Node& node, const audit::Misfit& misfit) {
  const std::string entry = meaning::name_of(misfit.at, node.description);
  if (misfit.is_missing)
    return fmt::format("node {}: it does not have {}, which its EDS has: the EDS may be of another device",
                       node.id, entry);
  const eds::EntryFacts* const facts = node.description.find(misfit.at.index, misfit.at.sub_index);
  const auto expected = facts == nullptr || !facts->initial ? std::nullopt : facts->initial->at(node.id);
  return fmt::format("node {}: {} is {:08X}h, and {:08X}h in its EDS: the EDS is of another device", node.id,
                     entry, misfit.value, expected ? expected->magnitude : 0);
}

}  // namespace

std::vector<std::string> sheet_remarks(const audit::Network& network) {
  std::vector<std::string> remarks;
  for (const audit::Node& node : network.nodes()) {
    if (node.description.empty()) continue;
    if (!node.is_there) remarks.push_back(fmt::format("node {}: there is an EDS of it, and no frame", node.id));
    if (node.misfit) remarks.push_back(misfit_text(node, *node.misfit));
  }
  return remarks;
}

}  // namespace audit_tool
