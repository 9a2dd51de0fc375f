// The NMT state machine of a node against a table of its own (CiA 301 7.3.2.2), by commands, services and time in
// any order.
#include <array>

#include <rapidcheck/gtest.h>

#include "tests/libcanopen/fixture/node_fixture.hpp"

namespace {

using canopen::NmtState;

constexpr std::uint8_t kStart = 0x01, kStop = 0x02, kEnterPreOperational = 0x80, kResetNode = 0x81,
                       kResetCommunication = 0x82;
constexpr std::array<std::uint8_t, 10> kCommands{
    kStart, kStop, kEnterPreOperational, kResetNode, kResetCommunication, 0x00, 0x03, 0x7F, 0x83, 0xFF};
constexpr std::array<std::uint8_t, 4> kNodes{0, 5, 6, 127};

NmtState expected_after(NmtState state, std::uint8_t command) {
  switch (command) {
    case kStart:
      return NmtState::Operational;
    case kStop:
      return NmtState::Stopped;
    case kEnterPreOperational:
    case kResetNode:
    case kResetCommunication:
      return NmtState::PreOperational;
    default:
      return state;
  }
}

class Walk : public NodeTest {
 public:
  using NodeTest::start;
  void TestBody() override {}

  /// A frame of master, producer or consumer, drawn; the state is what the table says, and so is what is answered.
  void step() {
    const auto command = *rc::gen::elementOf(kCommands);
    const auto addressed = *rc::gen::elementOf(kNodes);
    const auto length = *rc::gen::inRange<unsigned>(0, 9);
    switch (*rc::gen::inRange(0, 4)) {
      case 0:
        return take(nmt_frame(command, addressed, 2), command, addressed == 0 || addressed == 5);
      case 1:
        return take(nmt_frame(command, addressed, length), command,
                    length == 2 && (addressed == 0 || addressed == 5));
      case 2:
        return ask();
      default:
        passes(std::chrono::milliseconds{*rc::gen::inRange(0, 50)});
        RC_ASSERT(node->state() == state);
    }
  }

  NmtState state = NmtState::PreOperational;

 private:
  static std::string nmt_frame(std::uint8_t command, std::uint8_t addressed, unsigned length) {
    std::string text = "000#";
    for (unsigned i = 0; i < length; ++i) {
      char byte[3];
      std::snprintf(byte, sizeof byte, "%02X", i == 0 ? command : i == 1 ? addressed : 0U);
      text += byte;
    }
    return text;
  }
  void take(const std::string& frame, std::uint8_t command, bool is_mine) {
    const Lines sent = says(frame.c_str());
    const bool boots = is_mine && (command == kResetNode || command == kResetCommunication);
    if (is_mine) state = expected_after(state, command);
    RC_ASSERT(node->state() == state);
    RC_ASSERT((std::ranges::count(sent, "705#00") == 1) == boots);
  }
  /// An SDO server answers but in Stopped.
  void ask() {
    const Lines sent = says("605#4000100000000000");
    RC_ASSERT(node->state() == state);
    RC_ASSERT(sent.empty() == (state == NmtState::Stopped));
  }
};

RC_GTEST_PROP(NmtWalk, FollowsTheTable, ()) {
  Walk walk;
  walk.start();
  const auto steps = *rc::gen::inRange(1, 100);
  for (int i = 0; i < steps; ++i) walk.step();
}

}  // namespace
