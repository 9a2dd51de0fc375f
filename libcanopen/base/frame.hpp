#pragma once

#include <array>
#include <cstdint>

#include "libcanopen/base/export.hpp"

namespace canopen {

/// A classical CAN frame as CiA 301 uses it. Sixteen bytes, laid out so that it copies in two words.
struct Frame {
  std::uint32_t id = 0;  ///< identifier (COB-ID without its control bits): 0..7FFh, with `extended` 0..1FFFFFFFh
  std::uint8_t length = 0;  ///< data length code, 0..8
  bool remote = false;      ///< remote transmission request; `data` is then meaningless
  bool extended = false;    ///< 29-bit identifier
  std::uint8_t reserved = 0;
  std::array<std::uint8_t, 8> data{};

  friend constexpr bool operator==(const Frame&, const Frame&) = default;
};
static_assert(sizeof(Frame) == 16);

/// How a frame may be treated when the bus cannot take it at once.
enum class Delivery : std::uint8_t {
  Ordered,      ///< must arrive, after everything sent before it (SDO, EMCY, NMT)
  Replaceable,  ///< a newer frame of the same identifier makes it obsolete (TPDO)
};

/// Where a node puts its frames. The owner implements it; it must not fail and must not call back into the node.
class CANOPEN_EXPORT FrameSink {
 public:
  virtual ~FrameSink() = default;
  /// Hands @p frame over for transmission.
  virtual void send(const Frame& frame, Delivery delivery) = 0;
};

}  // namespace canopen
