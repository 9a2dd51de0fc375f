#include "eds/lint/lint.hpp"

#include <array>

#include "eds/lint/rules.hpp"

namespace eds {
namespace {

using Group = void (*)(const DataSheet&, Findings&);
constexpr std::array<Group, 9> kGroups{
    check_lists,   check_objects,     check_entries, check_standard_objects, check_pdos,
    check_cob_ids, check_device_info, check_modules, check_configuration};

}  // namespace

Findings lint(std::string_view text, const std::string& file) {
  Findings findings{file};
  const Document document = read_document(text, findings);
  const DataSheet sheet = read_data_sheet(document, findings);
  check_sections(sheet, file, findings);
  for (const Group group : kGroups) group(sheet, findings);
  findings.sort();
  return findings;
}

}  // namespace eds
