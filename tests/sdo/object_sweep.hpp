#pragma once

#include "tests/sdo/sdo_client.hpp"

namespace sdo_test {

/// Every object of a new unit over SDO against the facts of the real one (tests/eds/data/objects.csv), without a
/// word of the catalogue in between. Each function prints how much it has compared.
class ObjectSweep {
 public:
  /// Node 5 with @p axes servo axes (1..8) behind @p client, Pre-operational.
  ObjectSweep(SdoClient& client, unsigned axes) : client_{client}, axes_{axes} {}

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
};

}  // namespace sdo_test
