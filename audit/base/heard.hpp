#pragma once

#include <chrono>
#include <cstdint>

#include "libcanopen/base/frame.hpp"
#include "libcanopen/base/nmt_state.hpp"
#include "libcanopen/base/time.hpp"
#include "meaning/cob_ids.hpp"

namespace audit {

/// @p time in milliseconds.
[[nodiscard]] constexpr double milliseconds(canopen::Duration time) noexcept {
  return std::chrono::duration<double, std::milli>{time}.count();
}

/// A frame as it was on the bus.
struct Heard {
  canopen::Frame frame{};
  canopen::Duration at{};   ///< since whatever the log counts from
  std::uint64_t place = 0;  ///< number of its line or record, from 1; live, of the frame
  bool is_error = false;    ///< an error frame: `frame.id` is the class of the error (linux/can/error.h)
};

/// The same with what it means.
struct Passage {
  Heard heard{};
  meaning::Meaning meaning{};
  bool is_shared = false;  ///< an RPDO of further nodes, too

  [[nodiscard]] const canopen::Frame& frame() const noexcept { return heard.frame; }
  [[nodiscard]] canopen::Duration at() const noexcept { return heard.at; }
  /// A boot-up message (CiA 301, 7.2.8.3.3).
  [[nodiscard]] bool is_boot_up() const noexcept {
    return meaning.role == meaning::Role::ErrorControl && frame().length == 1 && frame().data[0] == 0;
  }
  /// An NMT command that starts nodes.
  [[nodiscard]] bool is_start() const noexcept {
    return meaning.role == meaning::Role::Nmt && frame().length == 2 &&
           frame().data[0] == static_cast<std::uint8_t>(canopen::NmtCommand::Start);
  }
  /// An NMT command that resets nodes, or their communication.
  [[nodiscard]] bool is_reset() const noexcept {
    const auto command = static_cast<canopen::NmtCommand>(frame().data[0]);
    return meaning.role == meaning::Role::Nmt && frame().length == 2 &&
           (command == canopen::NmtCommand::ResetNode || command == canopen::NmtCommand::ResetCommunication);
  }
};

}  // namespace audit
