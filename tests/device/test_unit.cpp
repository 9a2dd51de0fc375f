#include "tests/device/test_unit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "libcanopen/base/little_endian.hpp"

namespace device {
namespace {

using canopen::Frame;

constexpr std::uint8_t kAbort = 0x80;
constexpr std::uint8_t kExpedited = 0x02;
constexpr std::uint8_t kToggle = 0x10;
constexpr std::uint8_t kLast = 0x01;

Frame request(std::uint8_t command, std::uint16_t index, std::uint8_t sub_index, std::uint32_t value = 0) {
  Frame frame{.length = 8};
  frame.data[0] = command;
  canopen::store(&frame.data[1], index);
  frame.data[3] = sub_index;
  canopen::store(&frame.data[4], value);
  return frame;
}

}  // namespace

std::uint64_t Upload::number() const {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) value |= std::uint64_t{bytes[i]} << (8 * i);
  return value;
}

Configuration unit_with(std::vector<ParameterPreset> presets) {
  return {.node_id = 5, .axes = {{.drive = {}, .presets = std::move(presets)}}};
}

Lines TestUnit::sent() {
  Lines lines;
  for (const Frame& frame : bus.take()) lines.push_back(fakes::candump(frame));
  return lines;
}

Lines TestUnit::start() {
  device.start(now);
  device.on_time(now);
  return sent();
}

Lines TestUnit::start_operational() {
  start();
  passes(100ms);
  return says("000#0105");
}

void TestUnit::enable() {
  start_operational();
  for (const char* const controlword : {"205#0600", "205#0700", "205#0F00"}) cycles_with(controlword);
  ASSERT_EQ(statusword() & 0x6F, 0x27);
}

void TestUnit::turn_at(double rpm, canopen::Duration time) {
  enable();
  Frame setpoint{.id = 0x305, .length = 6};
  canopen::store(&setpoint.data[0], std::uint16_t{0x000F});
  canopen::store(&setpoint.data[2], static_cast<std::int32_t>(std::lround(bus_speed(rpm))));
  says(fakes::candump(setpoint));
  passes(time);
  ASSERT_NEAR(velocity(), bus_speed(rpm), std::abs(bus_speed(rpm)) / 1000);
}

Lines TestUnit::says(std::string_view frame) {
  device.on_frame(fakes::frame_of(frame), now);
  if (device.next_deadline() <= now) device.on_time(now);
  return sent();
}

Lines TestUnit::passes(canopen::Duration time) {
  const canopen::TimePoint end = now + time;
  while (device.next_deadline() <= end) {
    now = std::max(now, device.next_deadline());
    device.on_time(now);
    if (device.next_deadline() > now) continue;
    ADD_FAILURE() << "the unit asks for a moment that it has just been told";
    break;
  }
  now = end;
  return sent();
}

Lines TestUnit::cycles_with(std::string_view frame) {
  Lines lines = says(frame);
  std::ranges::move(passes(Device::kCycle), std::back_inserter(lines));
  return lines;
}

bool TestUnit::reaches(std::uint16_t mask, std::uint16_t value, canopen::Duration limit) {
  const canopen::TimePoint end = now + limit;
  while ((statusword() & mask) != value) {
    if (now >= end) return false;
    passes(Device::kCycle);
  }
  return true;
}

void TestUnit::expect_dialogue(std::initializer_list<Exchange> exchanges) {
  for (const Exchange& exchange : exchanges) {
    const Lines expected = exchange.answer.empty() ? Lines{} : Lines{std::string{exchange.answer}};
    EXPECT_EQ(says(exchange.request), expected) << "answer to " << exchange.request;
  }
}

Frame TestUnit::asks(Frame request, const SdoServerIds& server) {
  request.id = server.request;
  device.on_frame(request, now);
  const std::vector<Frame> answers = bus.take();
  const auto answer = std::ranges::find(answers, server.response, &Frame::id);
  if (answer != answers.end()) return *answer;
  ADD_FAILURE() << "no answer to " << fakes::candump(request);
  return {.data = {kAbort}};
}

Upload TestUnit::upload(std::uint16_t index, std::uint8_t sub_index, const SdoServerIds& server) {
  Upload result;
  Frame answer = asks(request(0x40, index, sub_index), server);
  const auto word = canopen::load<std::uint32_t>(&answer.data[4]);
  if (answer.data[0] == kAbort) return {.abort_code = word};
  if ((answer.data[0] & kExpedited) != 0) {
    const auto unused = static_cast<std::ptrdiff_t>(answer.data[0] >> 2 & 3);
    result.bytes.assign(answer.data.begin() + 4, answer.data.end() - unused);
    return result;
  }
  std::uint8_t toggle = 0;
  do {
    answer = asks(request(static_cast<std::uint8_t>(0x60 | toggle), 0, 0), server);
    if (answer.data[0] == kAbort) return {.abort_code = canopen::load<std::uint32_t>(&answer.data[4])};
    const auto unused = static_cast<std::ptrdiff_t>(answer.data[0] >> 1 & 7);
    result.bytes.insert(result.bytes.end(), answer.data.begin() + 1, answer.data.end() - unused);
    toggle ^= kToggle;
  } while ((answer.data[0] & kLast) == 0);
  EXPECT_EQ(result.bytes.size(), word) << "size announced";
  return result;
}

std::uint32_t TestUnit::download(std::uint16_t index, std::uint8_t sub_index, std::uint32_t value, unsigned size,
                                 const SdoServerIds& server) {
  const auto command = static_cast<std::uint8_t>(0x23U | (4 - size) << 2);
  const Frame answer = asks(request(command, index, sub_index, value), server);
  return answer.data[0] == kAbort ? canopen::load<std::uint32_t>(&answer.data[4]) : 0;
}

Lines from(std::string_view identifier, const Lines& lines) {
  Lines chosen;
  std::ranges::copy_if(lines, std::back_inserter(chosen),
                       [=](const std::string& line) { return line.starts_with(identifier); });
  return chosen;
}

Lines at_rest(std::uint16_t statusword) {
  std::array<char, 5> word{};
  std::snprintf(word.data(), word.size(), "%02X%02X", statusword & 0xFFU, static_cast<unsigned>(statusword >> 8));
  const std::string text{word.data()};
  return {"185#" + text, "285#" + text + "00000000", "385#" + text + "0000", "485#" + text + "00000000"};
}

}  // namespace device
