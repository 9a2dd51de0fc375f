#pragma once

#include <cstdint>
#include <optional>

#include "libcanopen/base/frame.hpp"

namespace conformance {

/// Index and sub-index, as SDO requests and answers name them.
struct Multiplexor {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;

  friend bool operator==(const Multiplexor&, const Multiplexor&) = default;
};

/// What bytes 1 to 3 of @p frame name.
[[nodiscard]] Multiplexor multiplexor_of(const canopen::Frame& frame) noexcept;
/// True if @p frame of a server is an abort (CiA 301, 7.2.4.3.17).
[[nodiscard]] bool is_abort(const canopen::Frame& frame) noexcept;
/// True if @p request of a client names its entry: it initiates a transfer.
[[nodiscard]] bool names_its_entry(const canopen::Frame& request) noexcept;

/// Which frames of a server answer a request: those with a command that belongs to it and, where it names an
/// entry, with that entry; aborts that name the entry of the transfer (CiA 301, 7.2.4.3). What does not fit is the
/// late answer to another request, or somebody else's.
class SdoMatch {
 public:
  /// For @p request, which goes on with the transfer of @p transfer if it initiates none.
  SdoMatch(const canopen::Frame& request, std::optional<Multiplexor> transfer) noexcept;
  /// For the last segment of a sub-block of a block download of @p transfer.
  [[nodiscard]] static SdoMatch sub_block(std::optional<Multiplexor> transfer) noexcept;

  /// From now on aborts fit whatever entry they name.
  void take_any_abort() noexcept { entry_.reset(); }
  [[nodiscard]] bool fits(const canopen::Frame& answer) const noexcept;
  /// True if @p answer, which does not fit, is to be judged when nothing else comes in time: its command is none
  /// for this request, or it is an abort in the middle of a transfer.
  [[nodiscard]] bool stands_in(const canopen::Frame& answer) const noexcept;

 private:
  explicit SdoMatch(std::optional<Multiplexor> transfer) noexcept : entry_{transfer} {}

  std::optional<canopen::Frame> request_{};  ///< none: a sub-block
  std::optional<Multiplexor> entry_{};       ///< that an abort has to name; none: any
};

}  // namespace conformance
