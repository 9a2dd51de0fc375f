#pragma once

#include <cstdint>

#include "audit/base/heard.hpp"
#include "libcanopen/sdo/command.hpp"
#include "meaning/sdo_watch.hpp"

namespace audit {

/// A transfer of SDO that has ended.
struct Transfer {
  enum class End : std::uint8_t { Done, AbortedByServer, AbortedByClient };

  meaning::SdoChannel channel{};
  canopen::sdo::Address at{};
  bool is_write = false;
  End end = End::Done;
  bool is_malformed = false;     ///< the client has sent frames that no transfer has: an abort is for that
  std::uint32_t abort_code = 0;  ///< of End::AbortedByServer and End::AbortedByClient
  bool is_size_told = true;      ///< else it is expedited, and how many of its four bytes count is not said
  std::uint64_t bytes = 0;       ///< of the value, as far as it was transferred
  std::uint64_t value = 0;       ///< its first eight bytes, least significant first
  Heard request{}, last{};       ///< the frame that began it, and the one that ended it

  [[nodiscard]] bool is_done() const noexcept { return end == End::Done; }
  /// Done, and of @p index and @p sub_index.
  [[nodiscard]] bool is_written(std::uint16_t index, std::uint8_t sub_index) const noexcept {
    return is_done() && is_write && at.index == index && at.sub_index == sub_index;
  }
};

}  // namespace audit
