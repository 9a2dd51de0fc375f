#include "can/port/socketcand/socketcand_text.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "text/number.hpp"

namespace bus::socketcand {

namespace {

constexpr std::uint32_t kLargestStandard = 0x7FF;
constexpr std::uint32_t kLargestExtended = 0x1FFFFFFF;
constexpr std::size_t kExtendedDigits = 8;
constexpr std::int64_t kMicroseconds = 1'000'000;
constexpr std::size_t kMicrosecondDigits = 6;
constexpr std::string_view kSpaces = " \t\r\n\v\f";

using Parsed = tl::expected<Message, std::string_view>;

Parsed wrong(std::string_view reason) noexcept {
  return tl::unexpected{reason};
}

std::string_view trimmed(std::string_view text) noexcept {
  const std::size_t first = text.find_first_not_of(kSpaces);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpaces) - first + 1);
}

/// Takes the first word off @p text; empty if there is none.
std::string_view take_word(std::string_view& text) noexcept {
  text = trimmed(text);
  const std::string_view word = text.substr(0, text.find_first_of(kSpaces));
  text.remove_prefix(word.size());
  return word;
}

bool read_identifier(std::string_view word, canopen::Frame& frame) noexcept {
  const auto id = text::integer<std::uint32_t>(word, 16);
  if (!id || *id > kLargestExtended || word.size() > kExtendedDigits) return false;
  frame.id = *id;
  frame.extended = word.size() == kExtendedDigits || *id > kLargestStandard;
  return true;
}

/// Seconds and a fraction of any number of digits, as microseconds.
std::optional<std::int64_t> read_time(std::string_view word) noexcept {
  constexpr std::int64_t kMostSeconds = INT64_MAX / kMicroseconds - 1;
  const std::size_t point = std::min(word.find('.'), word.size());
  const auto seconds = text::integer<std::int64_t>(word.substr(0, point), 10);
  if (!seconds || *seconds < 0 || *seconds > kMostSeconds) return std::nullopt;
  std::array<char, kMicrosecondDigits> digits{};
  digits.fill('0');
  const std::string_view fraction = word.substr(std::min(point + 1, word.size()));
  std::copy_n(fraction.begin(), std::min(fraction.size(), digits.size()), digits.begin());
  const auto microseconds = text::integer<std::uint32_t>({digits.data(), digits.size()}, 10);
  if (!microseconds) return std::nullopt;
  return *seconds * kMicroseconds + *microseconds;
}

/// Reads bytes of one or two digits each, with spaces between.
bool read_spaced_bytes(std::string_view text, canopen::Frame& frame) noexcept {
  for (std::size_t i = 0; i < frame.length; ++i) {
    const auto byte = text::integer<std::uint8_t>(take_word(text), 16);
    if (!byte) return false;
    frame.data[i] = *byte;
  }
  return trimmed(text).empty();
}

/// Reads bytes of two digits each, with or without spaces between.
bool read_bytes(std::string_view text, canopen::Frame& frame) noexcept {
  for (std::string_view word = take_word(text); !word.empty(); word = take_word(text)) {
    for (; !word.empty(); word.remove_prefix(2)) {
      const auto byte = word.size() < 2 ? std::nullopt : text::integer<std::uint8_t>(word.substr(0, 2), 16);
      if (!byte || frame.length == frame.data.size()) return false;
      frame.data[frame.length++] = *byte;
    }
  }
  return true;
}

template <class Plain>
Parsed parse_plain(std::string_view rest) noexcept {
  if (!rest.empty()) return wrong("this command takes no argument");
  return Plain{};
}

Parsed parse_open(std::string_view rest) noexcept {
  const std::string_view name = take_word(rest);
  if (name.empty() || !trimmed(rest).empty()) return wrong("open expects one name");
  return Open{name};
}

Parsed parse_error(std::string_view rest) noexcept {
  return Error{rest};
}

Parsed parse_send(std::string_view rest) noexcept {
  canopen::Frame frame;
  if (!read_identifier(take_word(rest), frame))
    return wrong("send expects a hexadecimal identifier up to 1FFFFFFF");
  const auto length = text::integer<std::uint8_t>(take_word(rest), 10);
  if (!length || *length > frame.data.size()) return wrong("send expects a length of 0 to 8");
  frame.length = *length;
  if (!read_spaced_bytes(rest, frame)) return wrong("send expects as many hexadecimal bytes as its length");
  return Send{frame};
}

Parsed parse_frame(std::string_view rest) noexcept {
  FrameSeen seen;
  if (!read_identifier(take_word(rest), seen.frame))
    return wrong("frame expects a hexadecimal identifier up to 1FFFFFFF");
  const auto time_us = read_time(take_word(rest));
  if (!time_us) return wrong("frame expects a time as SECONDS.MICROSECONDS");
  seen.time_us = *time_us;
  if (!read_bytes(rest, seen.frame)) return wrong("frame expects 0 to 8 bytes of two hexadecimal digits");
  return seen;
}

struct MessageKind {
  std::string_view word;
  Parsed (*parse)(std::string_view rest) noexcept;
};
constexpr std::array kMessageKinds{
    MessageKind{"send", parse_send},
    MessageKind{"frame", parse_frame},
    MessageKind{"error", parse_error},
    MessageKind{"hi", parse_plain<Hi>},
    MessageKind{"ok", parse_plain<Ok>},
    MessageKind{"open", parse_open},
    MessageKind{"rawmode", parse_plain<RawMode>},
    MessageKind{"echo", parse_plain<Echo>},
};

/// Prints a message of each kind to a room.
struct Printer {
  Room& room;

  std::string_view operator()(Hi) const noexcept { return "< hi >"; }
  std::string_view operator()(Ok) const noexcept { return "< ok >"; }
  std::string_view operator()(RawMode) const noexcept { return "< rawmode >"; }
  std::string_view operator()(Echo) const noexcept { return "< echo >"; }
  std::string_view operator()(const Open& open) const noexcept { return with_text("< open ", open.name); }
  std::string_view operator()(const Error& error) const noexcept { return with_text("< error ", error.text); }

  std::string_view operator()(const Send& send) const noexcept {
    if (send.frame.remote) return {};
    char* at =
        fmt::format_to(room.data(), "< send {:0{}X} {}", send.frame.id, digits_of(send.frame), length_of(send));
    for (std::size_t i = 0; i < length_of(send); ++i) at = fmt::format_to(at, " {:x}", send.frame.data[i]);
    return ended(at);
  }

  std::string_view operator()(const FrameSeen& seen) const noexcept {
    if (seen.frame.remote) return {};
    char* at = fmt::format_to(room.data(), "< frame {:0{}X} {}.{:06} ", seen.frame.id, digits_of(seen.frame),
                              seen.time_us / kMicroseconds, seen.time_us % kMicroseconds);
    for (std::size_t i = 0; i < length_of(seen); ++i) at = fmt::format_to(at, "{:02X}", seen.frame.data[i]);
    return ended(at);
  }

 private:
  static std::size_t digits_of(const canopen::Frame& frame) noexcept {
    constexpr std::size_t kStandardDigits = 3;
    return frame.extended ? kExtendedDigits : kStandardDigits;
  }

  template <class WithFrame>
  static std::size_t length_of(const WithFrame& message) noexcept {
    return std::min<std::size_t>(message.frame.length, message.frame.data.size());
  }

  std::string_view ended(char* at) const noexcept {
    constexpr std::string_view kEnd = " >";
    at = std::copy(kEnd.begin(), kEnd.end(), at);
    return {room.data(), static_cast<std::size_t>(at - room.data())};
  }

  std::string_view with_text(std::string_view begin, std::string_view text) const noexcept {
    constexpr std::size_t kEndSize = 2;
    char* at = std::copy(begin.begin(), begin.end(), room.data());
    text = text.substr(0, room.size() - begin.size() - kEndSize);
    at = std::replace_copy_if(
        text.begin(), text.end(), at, [](char c) { return c == '<' || c == '>'; }, '?');
    return ended(at);
  }
};

}  // namespace

Parsed parse(std::string_view text) noexcept {
  text = trimmed(text);
  if (text.size() < 2 || text.front() != '<' || text.back() != '>')
    return wrong("a message stands between < and >");
  std::string_view rest = trimmed(text.substr(1, text.size() - 2));
  const std::string_view word = take_word(rest);
  const auto* found = std::find_if(kMessageKinds.begin(), kMessageKinds.end(),
                                   [word](const MessageKind& row) { return row.word == word; });
  return found == kMessageKinds.end() ? wrong("unknown command") : found->parse(trimmed(rest));
}

std::string_view print(const Message& message, Room& room) noexcept {
  return std::visit(Printer{room}, message);
}

std::span<char> MessageReader::room() noexcept {
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
            buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
  end_ -= begin_;
  begin_ = 0;
  return std::span{buffer_}.subspan(end_);
}

MessageReader::Found MessageReader::next() noexcept {
  for (;;) {
    const std::string_view left{buffer_.data() + begin_, end_ - begin_};
    const std::size_t first = skipping_ ? 0 : std::min(left.find('<'), left.size());
    const std::size_t last = left.find('>', first);
    if (last == std::string_view::npos) return unfinished(left.substr(first));
    begin_ += last + 1;
    if (std::exchange(skipping_, false)) continue;
    const std::string_view text = left.substr(first, last - first + 1);
    if (text.size() > kLongestMessage) return {Found::Kind::TooLong, {}};
    return {Found::Kind::Complete, text};
  }
}

/// Keeps what has @p begun, unless it is too long already: the buffer never fills.
MessageReader::Found MessageReader::unfinished(std::string_view begun) noexcept {
  begin_ = end_ - begun.size();
  if (skipping_) begin_ = end_;
  if (skipping_ || begun.size() < kLongestMessage) return {};
  begin_ = end_;
  skipping_ = true;
  return {Found::Kind::TooLong, {}};
}

}  // namespace bus::socketcand
