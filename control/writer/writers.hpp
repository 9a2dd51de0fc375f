#pragma once

#include <string>

#include "control/writer/protocol_text.hpp"

namespace control {

/// The header with the rows of all methods: kMethods and kGroups.
std::string write_table(const ProtocolText& text);

/// JSON Schema (draft 2020-12) of every line of either side: requests, answers by method, errors, notices.
std::string write_schema(const ProtocolText& text);

/// What docs/reference/control.md says of methods, results and error codes.
std::string write_page(const ProtocolText& text);

/// @p page with @p part in the place of what stands between its marks. Throws std::runtime_error without marks.
std::string with_part(const std::string& page, const std::string& part);

}  // namespace control
