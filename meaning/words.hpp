#pragma once

#include <cstdint>
#include <string>

#include "eds/description/description.hpp"
#include "libcanopen/base/frame.hpp"
#include "libcanopen/sdo/command.hpp"
#include "meaning/cob_ids.hpp"

namespace meaning {

/// What @p frame says, in words: "SDO request to node 5: read 6041h:00 (Statusword)", "RPDO 1 of node 5",
/// "heartbeat Operational of node 5"; names are those of @p description. Empty if it means nothing.
[[nodiscard]] std::string words_of(const canopen::Frame& frame, const Meaning& meaning,
                                   const eds::Description& description);

/// "6041h:00 (Statusword)".
[[nodiscard]] std::string name_of(const canopen::sdo::Address& at, const eds::Description& description);

/// "06020000h (no such object)", or the number alone if CiA 301 has no such code.
[[nodiscard]] std::string abort_text(std::uint32_t code);

/// What @p frame is in the predefined connection set (CiA 301, 7.3.3): "SDO response", "NMT start"; empty:
/// unknown.
[[nodiscard]] std::string service_of(const canopen::Frame& frame);

}  // namespace meaning
