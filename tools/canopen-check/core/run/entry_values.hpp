#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "tools/canopen-check/core/sdo_client.hpp"

namespace conformance {

/// Index and sub-index.
using Entry = std::pair<std::uint16_t, std::uint8_t>;
/// What entries hold, as an upload gives it.
using EntryValues = std::map<Entry, std::vector<std::uint8_t>>;

/// Those of @p wanted that the node is not seen to hold; they have to be looked at alone. Entries of at most four
/// bytes are asked for together (SdoClient::ask_together), longer ones not at all.
[[nodiscard]] EntryValues not_seen_in(SdoClient& sdo, const EntryValues& wanted);

}  // namespace conformance
