#include "daemon/server/stream_lines.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "control/protocol.hpp"

namespace axisd {
namespace {

/// The longest text of a frame, with its quotes: of a time of 12 digits before the point.
constexpr std::size_t kFrameText = 64;
/// The longest text of a number.
constexpr std::size_t kNumberText = 26;
/// What else stands in a line, the name of the unit aside.
constexpr std::size_t kFrameOfLine = 256;
constexpr std::array kHexadecimal{'0', '1', '2', '3', '4', '5', '6', '7', '8', '9', 'A', 'B', 'C', 'D', 'E', 'F'};
constexpr unsigned kNibble = 4;
constexpr unsigned kShortId = 3;  // digits
constexpr unsigned kLongId = 8;

using Text = std::string;

void add_hexadecimal(Text& text, std::uint32_t number, unsigned digits) {
  for (unsigned digit = digits; digit-- > 0;) text.push_back(kHexadecimal[number >> (digit * kNibble) & 0xFU]);
}

/// Seconds with six decimals.
void add_time(Text& text, canopen::Duration time) {
  constexpr std::int64_t kMicroseconds = 1'000'000;
  const std::int64_t count = std::chrono::floor<std::chrono::microseconds>(time).count();
  fmt::format_to(std::back_inserter(text), "{}.{:06}", count / kMicroseconds, count % kMicroseconds);
}

/// As candump shows it: 205#0F00; a remote frame 205#R.
void add_frame(Text& text, const canopen::Frame& frame) {
  add_hexadecimal(text, frame.id, frame.extended ? kLongId : kShortId);
  text.push_back('#');
  if (frame.remote) return text.push_back('R');
  for (std::size_t at = 0; at < frame.length && at < frame.data.size(); ++at)
    add_hexadecimal(text, frame.data[at], 2);
}

void add_number(Text& text, double number) {
  if (std::isfinite(number))
    fmt::format_to(std::back_inserter(text), "{}", number);
  else
    text += "null";
}

/// How many items of at most @p size bytes each have room in a line of @p unit.
std::size_t room_in_line(const std::string& unit, std::size_t size) {
  const std::size_t room = control::kMaximumLine - kFrameOfLine - unit.size();
  return std::max<std::size_t>(room / size, 1);
}

Text frames_text(const std::string& unit, const FrameBuffer& buffer, std::size_t count, std::uint64_t lost) {
  Text text;
  text.reserve(kFrameOfLine + unit.size() + count * kFrameText);
  text.append(R"({"frames":{"unit":)").append(unit).append(R"(,"t":)");
  add_time(text, buffer[count - 1].time);
  text += R"(,"frames":[)";
  for (std::size_t at = 0; at < count; ++at) {
    const FrameBuffer::Passed& passed = buffer[at];
    text += at == 0 ? "\"" : ",\"";
    add_time(text, passed.time);
    text += passed.direction == Direction::Received ? " R " : " S ";
    add_frame(text, passed.frame);
    text.push_back('"');
  }
  fmt::format_to(std::back_inserter(text), R"(],"lost":{}}}}}{})", lost, '\n');
  return text;
}

void add_signal(Text& text, const SampleBuffer& buffer, std::size_t signal, std::size_t count) {
  text += signal == 0 ? "[" : ",[";
  for (std::size_t at = 0; at < count; ++at) {
    if (at != 0) text.push_back(',');
    add_number(text, buffer.value(at, signal));
  }
  text.push_back(']');
}

Text samples_text(const std::string& unit, const SampleBuffer& buffer, std::size_t count, std::uint64_t lost) {
  Text text;
  text.append(R"({"samples":{"unit":)").append(unit).append(R"(,"t":[)");
  for (std::size_t at = 0; at < count; ++at) {
    if (at != 0) text.push_back(',');
    add_time(text, buffer.time(at));
  }
  text += R"(],"values":[)";
  for (std::size_t signal = 0; signal < buffer.width(); ++signal) add_signal(text, buffer, signal, count);
  fmt::format_to(std::back_inserter(text), R"(],"lost":{}}}}}{})", lost, '\n');
  return text;
}

/// All that waits in @p buffer, by @p text_of, at most @p most in a line.
template <class Buffer, class TextOf>
std::vector<Text> lines_of(const std::string& unit, Buffer& buffer, std::size_t most, TextOf text_of) {
  std::vector<Text> lines;
  std::size_t left = buffer.waiting();  // what comes meanwhile is told the next time
  std::uint64_t lost = left == 0 ? 0 : buffer.take_lost();
  while (left > 0) {
    const std::size_t count = std::min(left, most);
    lines.push_back(text_of(unit, buffer, count, std::exchange(lost, 0)));
    buffer.release(count);
    left -= count;
  }
  return lines;
}

std::string quoted(std::string_view unit) {
  return nlohmann::json(unit).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

std::vector<std::string> frame_lines(std::string_view unit, FrameBuffer& buffer) {
  const std::string name = quoted(unit);
  return lines_of(name, buffer, room_in_line(name, kFrameText), frames_text);
}

std::vector<std::string> sample_lines(std::string_view unit, SampleBuffer& buffer) {
  const std::string name = quoted(unit);
  return lines_of(name, buffer, room_in_line(name, kNumberText * (buffer.width() + 1)), samples_text);
}

}  // namespace axisd
