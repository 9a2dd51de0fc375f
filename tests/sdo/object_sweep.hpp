#pragma once

#include "tests/sdo/sdo_client.hpp"

namespace sdo_test {

/// The devices whose objects are known.
enum class SweptDevice : std::uint8_t {
  Unit,    ///< the drive unit, by the facts of the real one (tests/eds/data/objects.csv)
  Cia402,  ///< a CiA 402 device (tests/eds/data/cia402-objects.csv)
};

/// Every object of a new device over SDO against what is known of it, without a word of the catalogue in between.
/// Each function prints how much it has compared.
class ObjectSweep {
 public:
  /// Node 5 with @p axes servo axes (1..8) behind @p client, Pre-operational.
  ObjectSweep(SdoClient& client, unsigned axes, SweptDevice device = SweptDevice::Unit)
      : client_{client}, axes_{axes}, device_{device} {}

  /// Every entry is there, with its size, default value, access and limits; the values that it writes are legal
  /// ones or must be refused.
  void find_every_entry();
  /// No other object from 1000h to 9FFFh is there, the parameters 2000h to 470Fh apart if @p parameters says that
  /// they are shown, and no sub-index above the last one of each.
  void find_nothing_else(bool parameters);
  /// 1027h lists the axes.
  void find_the_modules();

 private:
  SdoClient& client_;
  unsigned axes_;
  SweptDevice device_;
};

}  // namespace sdo_test
