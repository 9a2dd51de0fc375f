#include "tests/modbus/stream_properties.hpp"

#include <algorithm>
#include <deque>

#include <fmt/format.h>

#include "modbus/functions.hpp"
#include "tests/modbus/hexadecimal.hpp"
#include "tests/modbus/served_unit.hpp"

namespace modbus {
namespace {

using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t kFirstTaking = 240;
constexpr std::uint16_t kRampUp = 1120, kRampDown = 1121, kCurrentLimit = 640, kReferenceSpeed = 2000;

/// The unit that all inputs have, and a connection of their own.
class Stream {
 public:
  Stream() : connection_{unit().registers, counters_} {}

  std::string feed(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
      const auto room = connection_.room();
      const std::size_t taken = std::min(room.size(), bytes.size());
      std::copy_n(bytes.begin(), taken, room.begin());
      if (taken != 0) connection_.on_received(taken);
      pending_.insert(pending_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(taken));
      bytes = bytes.subspan(taken);
      connection_.answer(2);
      if (std::string broken = expect_answers(); !broken.empty()) return broken;
      if (connection_.is_over()) break;
      if (taken == 0) take(connection_.to_send().size());
    }
    return {};
  }
  std::string finish() {
    for (int i = 0; i < 1000 && (connection_.has_request() || !connection_.to_send().empty()); ++i) {
      connection_.answer(4);
      if (std::string broken = expect_answers(); !broken.empty()) return broken;
      take(connection_.to_send().size());
    }
    return connection_.has_request() ? "a whole request is not answered" : "";
  }
  void take(std::size_t bytes) {
    const std::size_t taken = std::min(bytes, connection_.to_send().size());
    checked_ -= taken;
    connection_.on_sent(taken);
  }
  static void passes() { unit().passes(4ms); }

  /// What a master has written is as in a new unit again.
  static void restore() {
    constexpr double kSeconds = 10.0, kRpm = 3000.0;
    unit().set(2, kRampUp, kSeconds);
    unit().set(2, kRampDown, kSeconds);
    unit().set(2, kReferenceSpeed, kRpm);
    static const double kCurrent = unit().value(2, kCurrentLimit);
    unit().set(2, kCurrentLimit, kCurrent);
    unit().passes(12ms);
  }

 private:
  static ServedUnit& unit() {
    static ServedUnit unit;
    return unit;
  }
  /// Looks at the answers that are new.
  std::string expect_answers() {
    for (auto answers = connection_.to_send(); checked_ < answers.size();) {
      const auto answer = first_frame(answers.subspan(checked_));
      const auto request = first_frame(pending_);
      if (!answer || !*answer) return "an answer that is no frame: " + hexadecimal(answers.subspan(checked_));
      if (!request || !*request) return "an answer to nothing: " + hexadecimal((*answer)->pdu);
      const bool is_its = (*answer)->transaction == (*request)->transaction &&
                          (*answer)->unit == (*request)->unit &&
                          ((*answer)->pdu[0] & ~kExceptionBit) == ((*request)->pdu[0] & ~kExceptionBit);
      if (!is_its)
        return fmt::format("{} is answered by {}", hexadecimal((*request)->pdu), hexadecimal((*answer)->pdu));
      checked_ += (*answer)->bytes;
      pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>((*request)->bytes));
    }
    return {};
  }

  Counters counters_;
  Connection connection_;
  Bytes pending_;            ///< what has come and is not answered
  std::size_t checked_ = 0;  ///< bytes of the answers that wait
};

}  // namespace

std::string broken_rule(std::span<const std::uint8_t> input) {
  Stream stream;
  std::string broken;
  while (!input.empty() && broken.empty()) {
    const std::uint8_t what = input.front();
    input = input.subspan(1);
    if (what == 0) {
      Stream::passes();
    } else if (what >= kFirstTaking) {
      stream.take((what - kFirstTaking) * std::size_t{16});
    } else {
      const std::size_t bytes = std::min<std::size_t>(what, input.size());
      broken = stream.feed(input.first(bytes));
      input = input.subspan(bytes);
    }
  }
  if (broken.empty()) broken = stream.finish();
  Stream::restore();
  return broken;
}

}  // namespace modbus
