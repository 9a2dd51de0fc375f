// Frames, time and faults that come to whole units, as bytes: an event is a byte that says what, and what that
// needs.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "tests/cia402/face/test_device.hpp"
#include "tests/device/test_unit.hpp"
#include "tests/fuzz/byte_source.hpp"
#include "tests/fuzz/readers/readers.hpp"

namespace fuzz {
namespace {

/// What is sent at most in one event: all PDOs, EMCYs of all axes, an answer.
constexpr std::size_t kMostFrames = 64;
/// Identifiers that a unit with node-ID 5 may listen to.
constexpr std::array<std::uint32_t, 14> kIdentifiers{0x000, 0x080, 0x205, 0x305, 0x405, 0x505, 0x605,
                                                     0x606, 0x701, 0x705, 0x7E5, 0x100, 0x085, 0x207};
constexpr std::array<std::uint16_t, 8> kFaults{7900, 7901, 30001, 7011, 31100, 8501, 7860, 30021};

canopen::Frame frame_from(fuzz::ByteSource& bytes) {
  canopen::Frame frame;
  const std::uint8_t which = bytes.u8();
  frame.id = kIdentifiers[which % kIdentifiers.size()];
  frame.remote = which >= 0xF0;
  frame.length = static_cast<std::uint8_t>(bytes.u8() % 9);
  if (which % 3 != 0) frame.length = 8;
  if (!frame.remote)
    for (std::uint8_t i = 0; i < frame.length; ++i) frame.data[i] = bytes.u8();
  return frame;
}

template <class Unit>
std::string play(Input input) {
  Unit unit;
  unit.start();
  fuzz::ByteSource bytes{std::span{reinterpret_cast<const std::uint8_t*>(input.data()), input.size()}};
  while (!bytes.is_empty()) {
    const std::uint8_t what = bytes.u8();
    switch (what % 8) {
      case 0:
        unit.passes(std::chrono::milliseconds{what / 8});
        break;
      case 1:
        static_cast<void>(unit.device.raise(1, kFaults[what / 8 % kFaults.size()], what, unit.now));
        break;
      default:
        unit.device.on_frame(frame_from(bytes), unit.now);
        break;
    }
    if (unit.device.next_deadline() <= unit.now) unit.device.on_time(unit.now);
    if (unit.device.next_deadline() <= unit.now) return "a deadline is left when it has been told the time";
    const std::size_t sent = unit.bus.take().size();
    if (what % 8 != 0 && sent > kMostFrames) return fmt::format("{} frames at once", sent);
  }
  return "";
}

}  // namespace

std::string read_frames(Input input) {
  return play<device::TestUnit>(input);
}

std::string read_frames_402(Input input) {
  return play<cia402::TestDevice>(input);
}

std::vector<std::string> made_frames() {
  using namespace std::string_literals;
  const std::string start{"\x02\x00\x02\x01\x05"s};
  return {
      start, start + "\x80"s,
      start + "\x02\x06\x08\x40\x41\x60\x00\x00\x00\x00\x00"s + "\x02\x02\x06\x7F\x04\x00\x00\x00\x00"s + "\x81"s};
}

}  // namespace fuzz
