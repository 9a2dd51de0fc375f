#include "tests/libcanopen/node_fixture.hpp"

#include "libcanopen/sdo/command.hpp"

using canopen::Frame;
using canopen::NmtState;

NodeTest::Lines NodeTest::sent() {
  Lines lines;
  for (const Frame& frame : bus.take()) lines.push_back(fakes::candump(frame));
  return lines;
}

NodeTest::Lines NodeTest::start() {
  node->start(now);
  node->on_time(now);
  return sent();
}

void NodeTest::start_operational() {
  start();
  says("000#0105");
  ASSERT_EQ(node->state(), NmtState::Operational);
  application.told.clear();
}

NodeTest::Lines NodeTest::says(std::string_view frame) {
  node->on_frame(fakes::frame_of(frame), now);
  node->on_time(now);
  return sent();
}

NodeTest::Lines NodeTest::passes(canopen::Duration time) {
  const canopen::TimePoint end = now + time;
  Lines lines;
  while (node->next_deadline() <= end) {
    now = std::max(now, node->next_deadline());
    node->on_time(now);
    if (node->next_deadline() <= now) {
      ADD_FAILURE() << "the node asks for a moment that it has just been told";
      return lines;
    }
    const auto at = std::chrono::duration_cast<std::chrono::milliseconds>(now - kStart).count();
    for (const std::string& line : sent()) lines.push_back(std::to_string(at) + "ms " + line);
  }
  now = end;
  return lines;
}

NodeTest::Lines NodeTest::sets(std::uint16_t index, std::int64_t value) {
  store_value(index, 0, value);
  node->on_values_changed(now);
  return sent();
}

void NodeTest::store_value(std::uint16_t index, std::uint8_t sub_index, std::int64_t value) {
  dictionary.set(*dictionary.find(index, sub_index).value(), value);
}

std::int64_t NodeTest::value_of(std::uint16_t index, std::uint8_t sub_index) const {
  return dictionary.stored(*dictionary.find(index, sub_index).value());
}

std::uint32_t NodeTest::writes(std::uint16_t index, std::uint8_t sub_index, std::uint32_t value, unsigned size) {
  const auto command = static_cast<std::uint8_t>(0x23U | (4 - size) << 2);
  const Frame request = canopen::sdo::response(0x605, command, {index, sub_index}, value);
  bus.take();
  node->on_frame(request, now);
  const auto found = std::ranges::find(bus.sent, 0x585U, &Frame::id);  // a PDO may come before it
  if (found == bus.sent.end()) {
    ADD_FAILURE() << "no answer to " << fakes::candump(request);
    return 0;
  }
  const Frame answer = *found;
  bus.sent.erase(found);
  if (answer.data[0] == 0x60) return 0;
  EXPECT_EQ(answer.data[0], 0x80) << fakes::candump(answer);
  return canopen::load<std::uint32_t>(&answer.data[4]);
}

void NodeTest::expect_dialogue(std::initializer_list<Exchange> exchanges) {
  for (const Exchange& exchange : exchanges) {
    const Lines expected = exchange.answer.empty() ? Lines{} : Lines{std::string{exchange.answer}};
    EXPECT_EQ(says(exchange.request), expected) << "answer to " << exchange.request;
  }
}
