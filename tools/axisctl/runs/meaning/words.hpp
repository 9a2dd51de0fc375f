#pragma once

#include <string>

#include "tools/axisctl/connection/failure.hpp"
#include "tools/axisctl/runs/meaning/cob_ids.hpp"

namespace runs {

/// What @p frame says, in words: "SDO request to node 5: read 6041h:00 (Statusword)", "RPDO 1 of node 5",
/// "heartbeat Operational of node 5"; names are those of @p description. Empty if it means nothing.
[[nodiscard]] std::string words_of(const canopen::Frame& frame, const Meaning& meaning,
                                   const conformance::Description& description);

/// "6041h:00 (Statusword)".
[[nodiscard]] std::string name_of(const canopen::sdo::Address& at, const conformance::Description& description);

/// Reads the EDS or DCF @p path for the node @p node; an empty path: nothing is known.
[[nodiscard]] axisctl::Expected<conformance::Description> read_description(const std::string& path,
                                                                           std::uint8_t node);

}  // namespace runs
