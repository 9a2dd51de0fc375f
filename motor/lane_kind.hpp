#pragma once

#include <cstdint>

namespace motor {

/// What axes have in common that can be advanced side by side: which control leads which machine on which shaft.
struct LaneKind {
  std::uint8_t control = 0;
  std::uint8_t machine = 0;
  std::uint8_t shaft = 0;
  bool with_encoder = false;

  friend bool operator==(const LaneKind&, const LaneKind&) = default;
};

}  // namespace motor
