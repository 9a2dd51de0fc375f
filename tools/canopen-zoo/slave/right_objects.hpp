#pragma once

#include <string>
#include <vector>

#include "libcanopen/od/entry_description.hpp"

namespace zoo {

/// The dictionary of a slave that does everything right: every service of libcanopen, four PDOs each way, and
/// application objects of each kind. Texts in it are constants.
[[nodiscard]] std::vector<canopen::EntryDescription> right_objects();

/// The row @p index, @p sub_index of @p table, which must be there.
[[nodiscard]] canopen::EntryDescription& row(std::vector<canopen::EntryDescription>& table, std::uint16_t index,
                                             std::uint8_t sub_index = 0);

/// The EDS of a slave with the dictionary @p table: CiA 306, without a finding of edstool lint.
[[nodiscard]] std::string eds_of(const std::vector<canopen::EntryDescription>& table);

// Objects of the application.
inline constexpr std::uint16_t kCounter = 0x2000;    ///< UNSIGNED32 ro, mappable: counts the RPDOs that came
inline constexpr std::uint16_t kStep = 0x2001;       ///< UNSIGNED16 rww, mappable
inline constexpr std::uint16_t kLimited = 0x2002;    ///< INTEGER16 rw, -100 to 100
inline constexpr std::uint16_t kDocument = 0x2003;   ///< DOMAIN rw, kept in memory
inline constexpr std::uint16_t kText = 0x2004;       ///< VISIBLE_STRING rw
inline constexpr std::uint16_t kWriteOnly = 0x2005;  ///< UNSIGNED16 wo
inline constexpr std::uint16_t kWide = 0x2006;       ///< UNSIGNED64 rw
inline constexpr std::uint16_t kMirror = 0x2007;     ///< UNSIGNED16 rwr, mappable: what kStep was last

}  // namespace zoo
