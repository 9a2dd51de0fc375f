#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "libcanopen/base/frame.hpp"
#include "libcanopen/sdo/command.hpp"

namespace meaning {

/// A channel of SDO: which server of which node.
struct SdoChannel {
  std::uint8_t node = 0;
  std::uint16_t server = 1;  ///< 1: that of 1200h

  // NOLINTNEXTLINE(modernize-use-nullptr): it takes the comparison with 0 for one with a pointer
  friend constexpr auto operator<=>(const SdoChannel&, const SdoChannel&) = default;
};

/// A value of an entry that SDO frames have told.
struct EntryValue {
  std::uint8_t node = 0;
  canopen::sdo::Address at{};
  std::uint32_t value = 0;
  bool is_write = false;  ///< else it was read
};

/// Follows expedited transfers: what has been written, and what was read.
class SdoWatch {
 public:
  /// Takes a request on @p channel.
  void take_request(SdoChannel channel, const canopen::Frame& request);
  /// Takes an answer: the value that the entry has now, if it tells one.
  [[nodiscard]] std::optional<EntryValue> take_response(SdoChannel channel, const canopen::Frame& response);

 private:
  std::map<SdoChannel, EntryValue> writes_;  ///< that were not answered yet
};

/// The bytes of an expedited upload that @p response brings, 1..4; 0 if it brings none.
[[nodiscard]] unsigned expedited_bytes(const canopen::Frame& response) noexcept;

}  // namespace meaning
