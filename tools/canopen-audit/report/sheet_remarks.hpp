#pragma once

#include <string>
#include <vector>

#include "audit/network/network.hpp"

namespace audit_tool {

/// Where the EDS of a node of @p network does not fit what was heard of it, a line each.
[[nodiscard]] std::vector<std::string> sheet_remarks(const audit::Network& network);

}  // namespace audit_tool
