#pragma once

#include <cstdint>

#include <linux/net_tstamp.h>
#include <sys/socket.h>

namespace preload {

/// The time stamps that a socket's messages carry, as OptionName::Timestamps keeps them.
class Stamps {
 public:
  constexpr explicit Stamps(uint32_t value = 0) : value_{value} {}

  [[nodiscard]] constexpr uint32_t value() const { return value_; }
  /// SO_TIMESTAMP… option that is on: 0 or one of the four numbers.
  [[nodiscard]] constexpr int single() const {
    if ((value_ & kOn) == 0) return 0;
    if ((value_ & kNanoseconds) != 0) return is_new() ? SO_TIMESTAMPNS_NEW : SO_TIMESTAMPNS_OLD;
    return is_new() ? SO_TIMESTAMP_NEW : SO_TIMESTAMP_OLD;
  }
  /// Switches the option @p name (SO_TIMESTAMP, SO_TIMESTAMPNS, old or new). They exclude one another.
  constexpr void set_single(int name, bool on) {
    value_ &= ~(kOn | kNanoseconds);
    if (!on) return;
    const bool nanoseconds = name == SO_TIMESTAMPNS_OLD || name == SO_TIMESTAMPNS_NEW;
    value_ |= kOn | (nanoseconds ? kNanoseconds : 0);
    set_new(name == SO_TIMESTAMP_NEW || name == SO_TIMESTAMPNS_NEW);
  }
  /// Flags of SO_TIMESTAMPING.
  [[nodiscard]] constexpr uint32_t flags() const { return value_ & kFlags; }
  /// Sets the flags of SO_TIMESTAMPING; @p name is its old or its new number.
  constexpr void set_flags(int name, uint32_t flags) {
    value_ = (value_ & ~kFlags) | (flags & kFlags);
    set_new(name == SO_TIMESTAMPING_NEW);
  }
  /// The number under which SO_TIMESTAMPING reports; 0 if it reports no time of the software.
  [[nodiscard]] constexpr int timestamping() const {
    if ((flags() & SOF_TIMESTAMPING_SOFTWARE) == 0) return 0;
    return is_new() ? SO_TIMESTAMPING_NEW : SO_TIMESTAMPING_OLD;
  }

 private:
  static constexpr uint32_t kFlags = 0x00FFFFFF;
  static constexpr uint32_t kOn = 1U << 24;
  static constexpr uint32_t kNanoseconds = 1U << 25;
  static constexpr uint32_t kNew = 1U << 26;

  [[nodiscard]] constexpr bool is_new() const { return (value_ & kNew) != 0; }
  constexpr void set_new(bool on) { value_ = on ? value_ | kNew : value_ & ~kNew; }

  uint32_t value_;
};

}  // namespace preload
