#include "tests/modbus/served_unit.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "tests/modbus/hexadecimal.hpp"

namespace modbus {

using namespace std::chrono_literals;

ServedUnit::ServedUnit(const unit::Configuration& configuration) : runner{configuration, shelf} {
  runner.attach(interface);
  runner.attach(face);
  runner.start(unit::TimePoint{1h});
  passes(20ms);
}

std::string ServedUnit::exchange(std::string_view frames) {
  const std::vector<std::uint8_t> bytes = bytes_of(frames);
  std::string answers;
  for (std::span<const std::uint8_t> rest = bytes; !rest.empty();) {
    const std::span<std::uint8_t> room = connection.room();
    if (room.empty()) break;
    const std::size_t taken = std::min(rest.size(), room.size());
    std::ranges::copy(rest.first(taken), room.begin());
    connection.on_received(taken);
    rest = rest.subspan(taken);
    do {
      connection.answer(1);
      answers += hexadecimal(connection.to_send());
      connection.on_sent(connection.to_send().size());
    } while (connection.has_request());
  }
  return answers;
}

int ServedUnit::read(std::uint16_t number) {
  const std::string answer = exchange(fmt::format("0001 0000 0006 01 03 {:04X} 0001", number - kFirstRegister));
  return answer.size() == 22 ? std::stoi(answer.substr(18), nullptr, 16) : -1;
}

int ServedUnit::write(std::uint16_t number, std::uint16_t value) {
  const std::string answer =
      exchange(fmt::format("0001 0000 0006 01 06 {:04X} {:04X}", number - kFirstRegister, value));
  return answer.size() == 24 ? 0 : std::stoi(answer.substr(16), nullptr, 16);
}

void ServedUnit::passes(unit::Duration time) {
  for (const unit::TimePoint end = runner.now() + time; runner.now() < end;) {
    runner.set_now(std::min(end, std::max(runner.now(), std::min(end, runner.next_deadline()))));
    runner.run_due();
    runner.follow_up();
  }
}

void ServedUnit::set(std::uint8_t object, std::uint16_t number, double value, std::size_t index) {
  static_cast<void>(runner.write_parameter(object, number, index, value, runner.now()));
}

double ServedUnit::value(std::uint8_t object, std::uint16_t number) const {
  return runner.unit().object(object)->read(number).value_or(-1.0);
}

}  // namespace modbus
