#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>

#include "can/port/port.hpp"

namespace hub {

/// Where frames come from when hubs are bridged to each other. The hub on which a frame came up marks it, bridges
/// carry the mark along, and a frame that a hub has seen already is not taken a second time, whatever ring the
/// bridges make.
class Origins {
 public:
  /// Hubs that are told apart; more take the place of those that were not heard longest.
  static constexpr std::size_t kMost = 32;
  /// How far behind the newest frame of its hub a frame may come and still be known (frames).
  static constexpr std::size_t kWindow = 4096;

  /// @p self tells this hub from others; not 0.
  explicit Origins(std::uint32_t self) noexcept : self_{self} {}
  /// With a number that no other hub has.
  Origins() noexcept;

  /// The number of this hub.
  [[nodiscard]] std::uint32_t self() const noexcept { return self_; }
  /// A mark for a frame that comes up here.
  [[nodiscard]] bus::Mark make() noexcept;
  /// True once for each mark; false for those of this hub, which come back. A frame without a mark is always new.
  [[nodiscard]] bool is_new(const bus::Mark& mark) noexcept;

 private:
  struct Origin {
    std::uint32_t hub = 0;
    std::uint32_t newest = 0;
    std::uint64_t heard = 0;    ///< when, counted in frames
    std::bitset<kWindow> seen;  ///< by number modulo kWindow, of the last kWindow numbers
  };

  Origin& origin_of(const bus::Mark& mark) noexcept;

  std::uint32_t self_;
  std::uint32_t number_ = 0;
  std::uint64_t clock_ = 0;
  std::array<Origin, kMost> origins_{};
};

}  // namespace hub
