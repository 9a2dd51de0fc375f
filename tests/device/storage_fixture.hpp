#pragma once

#include "tests/device/test_unit.hpp"

namespace device {

inline constexpr std::uint32_t kSave = 0x65766173;
inline constexpr std::uint32_t kLoad = 0x64616F6C;

inline constexpr std::uint16_t kStore = 0x1010;
inline constexpr std::uint16_t kRestore = 0x1011;
inline constexpr std::uint16_t kHaltOption = 0x605D;
inline constexpr std::uint16_t kAbortOption = 0x6007;

/// The unit after a power cut: a new device that is given what the former one had stored.
struct NextLife {
  explicit NextLife(const TestUnit& former, const Configuration& configuration = unit_with({}))
      : unit{configuration} {
    EXPECT_TRUE(unit.device.load_parameters(former.listener.image));
    unit.start();
  }
  TestUnit unit;
};

/// A unit whose window 2000h to 470Fh shows drive object @p object.
struct Window : TestUnit {
  explicit Window(std::uint16_t object) {
    start();
    show(object);
  }
  void show(std::uint16_t object) { ASSERT_EQ(download(0x41B6, 0, object, 2), 0U); }
  std::uint32_t write(std::uint16_t parameter, std::uint32_t value) {
    return download(static_cast<std::uint16_t>(0x2000 + parameter), 0, value, 2);
  }
  std::uint64_t read(std::uint16_t parameter) {
    return upload(static_cast<std::uint16_t>(0x2000 + parameter)).number();
  }
};

/// Gives RPDO 1 the identifier 215h and TPDO 1 the event timer 100 ms.
inline void change_pdos(TestUnit& unit) {
  ASSERT_EQ(unit.download(0x1400, 1, 0x80000205, 4), 0U);
  ASSERT_EQ(unit.download(0x1400, 1, 0x00000215, 4), 0U);
  ASSERT_EQ(unit.download(0x1800, 5, 100, 2), 0U);
}

/// Whether the unit takes RPDO 1 under 215h and not under 205h, and sends TPDO 1 every 100 ms.
inline bool has_changed_pdos(TestUnit& unit) {
  unit.says("000#0105");
  unit.passes(50ms);
  const bool sends = from("185#", unit.passes(200ms)).size() == 2;
  unit.says("215#0600");
  unit.says("205#0000");
  EXPECT_EQ(unit.upload(0x6040).number(), sends ? 6U : 0U);
  unit.says("000#8005");
  return sends;
}

}  // namespace device
