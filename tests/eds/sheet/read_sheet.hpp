#pragma once

#include <string>
#include <string_view>

#include "eds/sheet/data_sheet.hpp"

namespace eds {

/// The checks of @p findings with their lines, "check:line" each, separated by blanks.
inline std::string checks_of(const Findings& findings) {
  std::string list;
  for (const Finding& finding : findings.all())
    list += (list.empty() ? "" : " ") + std::string{finding.check} + ":" + std::to_string(finding.line);
  return list;
}

/// A data sheet with the document that it points into.
struct ReadSheet {
  explicit ReadSheet(std::string_view text, std::string name = "a.eds")
      : findings{std::move(name)},
        document{read_document(text, findings)},
        sheet{read_data_sheet(document, findings)} {}
  ReadSheet(const ReadSheet&) = delete;
  ReadSheet& operator=(const ReadSheet&) = delete;

  Findings findings;
  Document document;
  DataSheet sheet;
};

}  // namespace eds
