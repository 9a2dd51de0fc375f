#pragma once

#include "tests/libcanopen/service_fixture.hpp"

/// A node whose master guards it.
namespace guarding_test {

using canopen::NmtState;
using canopen::Policy;

inline constexpr const char* kMasterLost = "085#3081110000000000";
inline constexpr const char* kErrorReset = "085#0000000000000000";

class NodeGuarding : public ServiceTest {
 protected:
  using ServiceTest::ServiceTest;

  /// Boots the node with a life time of 3 times 50 ms.
  void start_guarded() {
    start();
    ASSERT_EQ(writes_u16(0x100C, 0, 50), 0U);
    ASSERT_EQ(writes_u8(0x100D, 0, 3), 0U);
    told();
  }
  /// Boots the node and lets the master fall silent.
  void start_and_lose() {
    start_guarded();
    says("705#R");
    ASSERT_EQ(passes(150ms), (Lines{std::string{"150ms "} + kMasterLost}));
    errors();
  }
};

}  // namespace guarding_test
