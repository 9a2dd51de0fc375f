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

}  // namespace

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

std::optional<Frame> TestUnit::ask(const Frame& request) {
  device.on_frame(request, now);
  const std::vector<Frame> answers = bus.take();
  const auto answer = std::ranges::find(answers, 0x585U, &Frame::id);
  return answer != answers.end() ? std::optional{*answer} : std::nullopt;
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
