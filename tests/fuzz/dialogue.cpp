#include "tests/fuzz/dialogue.hpp"

#include <sstream>
#include <string>

#include "libcanopen/base/cob_id.hpp"
#include "tests/fakes/candump.hpp"
#include "tests/fuzz/events.hpp"

namespace fuzz {
namespace {

using Bytes = std::vector<std::uint8_t>;

void begin(Bytes& bytes, EventKind kind, unsigned argument) {
  bytes.push_back(static_cast<std::uint8_t>(argument << 4 | static_cast<unsigned>(kind)));
}

void add_frame(Bytes& bytes, const std::string& line) {
  const canopen::Frame frame = fakes::frame_of(line);
  const auto data = std::span{frame.data}.first(frame.remote ? 0 : frame.length);
  const bool is_plain = !frame.extended && !frame.remote && frame.length == 8;
  if (is_plain && (frame.id == 0x605 || frame.id == 0x6A5)) {
    begin(bytes, EventKind::Request, frame.id == 0x605 ? 0 : 2);
  } else {
    const std::uint32_t word = canopen::identifier_of(frame) | (frame.remote ? canopen::cob_id::kNoRemote : 0);
    begin(bytes, EventKind::Any, frame.length);
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(word >> shift));
  }
  bytes.insert(bytes.end(), data.begin(), data.end());
}

/// A scale of EventKind::Time and what it is in microseconds.
struct Scale {
  unsigned number;
  std::uint64_t microseconds;
};
constexpr std::array kScales{Scale{0, 1},       Scale{1, 100},       Scale{2, 1000},      Scale{3, 10'000},
                             Scale{4, 100'000}, Scale{5, 1'000'000}, Scale{6, 10'000'000}};
constexpr unsigned kMeetsDeadlines = 8;

void add_wait(Bytes& bytes, std::uint64_t count, const std::string& unit) {
  const std::uint64_t time = count * (unit == "s" ? 1'000'000 : unit == "ms" ? 1000 : 1);
  for (const Scale& scale : kScales) {
    if (time % scale.microseconds != 0 || time / scale.microseconds > 255) continue;
    begin(bytes, EventKind::Time, kMeetsDeadlines | scale.number);
    bytes.push_back(static_cast<std::uint8_t>(time / scale.microseconds));
    return;
  }
  throw std::invalid_argument{"no time that one event can say: " + std::to_string(count) + unit};
}

void add_line(Bytes& bytes, const std::string& line) {
  std::istringstream words{line};
  std::string word, unit;
  words >> word;
  if (word.empty() || word[0] == ';' || word == "world") return;
  std::uint64_t count = 1;
  if (word == "wait") {
    words >> count >> unit;
    add_wait(bytes, count, unit);
  } else if (word == "deadline") {
    words >> count;
    begin(bytes, EventKind::Deadline, static_cast<unsigned>(words ? count - 1 : 0) & 0xF);
  } else if (word == "event") {
    while (words >> word) bytes.push_back(static_cast<std::uint8_t>(fakes::hexadecimal(word)));
  } else {
    add_frame(bytes, word);
  }
}

}  // namespace

std::vector<std::uint8_t> bytes_of_dialogue(std::string_view text) {
  std::istringstream lines{std::string{text}};
  Bytes bytes{text.starts_with("world ") ? static_cast<std::uint8_t>(text.at(6) - '0') : std::uint8_t{0}};
  for (std::string line; std::getline(lines, line);) add_line(bytes, line);
  return bytes;
}

}  // namespace fuzz
