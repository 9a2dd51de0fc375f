#pragma once

#include "tests/libcanopen/node_fixture.hpp"

/// A node whose TPDO 1 is event-driven.
class TransmitTest : public NodeTest {
 protected:
  void operate() { says("000#0105"); }
  /// Sets the times of TPDO 1 while it is invalid.
  void give_times(std::uint32_t inhibit_100us, std::uint32_t event_ms) {
    ASSERT_EQ(writes_u32(0x1800, 1, 0xC0000185), 0U);
    ASSERT_EQ(writes_u16(0x1800, 3, inhibit_100us), 0U);
    ASSERT_EQ(writes_u16(0x1800, 5, event_ms), 0U);
    ASSERT_EQ(writes_u32(0x1800, 1, 0x40000185), 0U);
  }
};
