#pragma once

#include <string>
#include <vector>

#include "control/writer/protocol_text.hpp"

namespace control {

/// A member of a result, for the page.
struct ResultRow {
  std::string key;  ///< with the keys it lies below: `axes[].state`
  std::string type;
  std::string meaning;
};

/// The members that @p schema describes, those below members too; not those of definitions that are objects, which
/// have a table of their own.
std::vector<ResultRow> rows_of(const ProtocolText& text, const Json& schema);

/// Whether @p schema describes an object with members.
bool is_object(const Json& schema);

}  // namespace control
