#pragma once

#include <cstdint>

#include "libcanopen/base/frame.hpp"
#include "libcanopen/base/time.hpp"
#include "meaning/cob_ids.hpp"

namespace audit {

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

  [[nodiscard]] const canopen::Frame& frame() const noexcept { return heard.frame; }
  [[nodiscard]] canopen::Duration at() const noexcept { return heard.at; }
};

}  // namespace audit
