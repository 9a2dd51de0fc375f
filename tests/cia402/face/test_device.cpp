#include "tests/cia402/face/test_device.hpp"

#include <algorithm>
#include <memory>

namespace cia402 {

TestDevice::TestDevice(const Configuration& configuration)
    : device{unit_configuration(configuration),
             [&](unit::Runner& runner) {
               return std::make_unique<Face>(configuration, runner, bus, listener, listener);
             },
             listener} {}

Lines TestDevice::sent() {
  Lines lines;
  for (const canopen::Frame& frame : bus.take()) lines.push_back(fakes::candump(frame));
  return lines;
}

Lines TestDevice::start() {
  device.start(now);
  device.on_time(now);
  return sent();
}

Lines TestDevice::start_operational() {
  start();
  passes(20ms);
  return says("000#0105");
}

void TestDevice::enable(Mode mode) {
  start_operational();
  ASSERT_EQ(write(0x6060, static_cast<std::int64_t>(mode)), 0U);
  for (const std::int64_t controlword : {0x06, 0x07, 0x0F}) ASSERT_EQ(write(0x6040, controlword), 0U);
  ASSERT_EQ(statusword() & 0x6F, 0x27);
  passes(20ms);
}

Lines TestDevice::says(std::string_view frame) {
  device.on_frame(fakes::frame_of(frame), now);
  if (device.next_deadline() <= now) device.on_time(now);
  return sent();
}

Lines TestDevice::passes(canopen::Duration time) {
  const canopen::TimePoint end = now + time;
  while (device.next_deadline() <= end) {
    now = std::max(now, device.next_deadline());
    device.on_time(now);
    if (device.next_deadline() > now) continue;
    ADD_FAILURE() << "the device asks for a moment that it has just been told";
    break;
  }
  now = end;
  return sent();
}

bool TestDevice::reaches(std::uint16_t mask, std::uint16_t value, canopen::Duration limit) {
  for (const canopen::TimePoint end = now + limit; now < end; passes(1ms))
    if ((statusword() & mask) == value) return true;
  return (statusword() & mask) == value;
}

std::uint32_t TestDevice::write(std::uint16_t index, std::uint8_t sub_index, std::int64_t value) {
  const canopen::Entry* const entry = device.dictionary().lookup(index, sub_index);
  return download(index, sub_index, static_cast<std::uint32_t>(value), entry != nullptr ? entry->size : 4U);
}

std::int64_t TestDevice::read(std::uint16_t index, std::uint8_t sub_index) {
  const sdo_test::Upload upload = this->upload(index, sub_index);
  EXPECT_EQ(upload.abort_code, 0U) << std::hex << index << ' ' << int{sub_index};
  const canopen::Entry* const entry = device.dictionary().lookup(index, sub_index);
  const auto number = static_cast<std::int64_t>(upload.number());
  const unsigned bits = 8U * entry->size;
  return entry->is_signed && (number >> (bits - 1) & 1) != 0 ? number - (std::int64_t{1} << bits) : number;
}

std::optional<canopen::Frame> TestDevice::ask(const canopen::Frame& request) {
  const std::vector<canopen::Frame> before = bus.take();
  device.on_frame(request, now);
  if (device.next_deadline() <= now) device.on_time(now);
  std::optional<canopen::Frame> answer;
  std::vector<canopen::Frame> rest = before;
  for (const canopen::Frame& frame : bus.take()) {
    if (frame.id == 0x585 && !answer)
      answer = frame;
    else
      rest.push_back(frame);
  }
  for (const canopen::Frame& frame : rest) bus.send(frame, {});
  return answer;
}

Lines from(std::string_view identifier, const Lines& lines) {
  Lines found;
  std::ranges::copy_if(lines, std::back_inserter(found),
                       [&](const std::string& line) { return line.starts_with(identifier); });
  return found;
}

}  // namespace cia402
