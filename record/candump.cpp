#include "record/candump.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "text/number.hpp"
#include "text/seconds.hpp"

namespace record {

namespace {

constexpr int kHexadecimal = 16;
constexpr std::size_t kShortIdentifier = 3;  // digits
constexpr std::size_t kLongIdentifier = 8;

using Wrong = tl::unexpected<std::string_view>;
constexpr std::string_view kFrame = "a frame as 123#1122, 12345678#1122 or 123#R behind the interface";

constexpr bool is_blank(char letter) noexcept {
  return letter == ' ' || letter == '\t' || letter == '\r';
}

/// Takes the blanks at the start of @p rest off it.
void skip_blanks(std::string_view& rest) noexcept {
  rest.remove_prefix(static_cast<std::size_t>(std::ranges::find_if_not(rest, is_blank) - rest.begin()));
}

/// Takes the word at the start of @p rest off it, and the blanks behind.
std::string_view take_word(std::string_view& rest) noexcept {
  const auto end = std::ranges::find_if(rest, is_blank);
  const std::string_view word = rest.substr(0, static_cast<std::size_t>(end - rest.begin()));
  rest.remove_prefix(word.size());
  skip_blanks(rest);
  return word;
}

/// The identifier with the flags that its digits tell.
std::optional<canid_t> read_identifier(std::string_view digits) noexcept {
  const auto number = text::integer<std::uint32_t>(digits, kHexadecimal);
  if (!number) return std::nullopt;
  if (digits.size() == kShortIdentifier) return *number <= CAN_SFF_MASK ? number : std::nullopt;
  if (digits.size() != kLongIdentifier || *number > (CAN_ERR_FLAG | CAN_ERR_MASK)) return std::nullopt;
  return (*number & CAN_ERR_FLAG) != 0 ? *number : *number | CAN_EFF_FLAG;
}

/// Reads what stands behind the R of a remote frame, its length.
bool read_length(std::string_view digits, can_frame& frame) noexcept {
  if (digits.empty()) return true;
  const auto length = text::integer<std::uint8_t>(digits);
  if (digits.size() > 1 || !length || *length > CAN_MAX_DLEN) return false;
  frame.len = *length;
  return true;
}

/// Reads data bytes of two digits, between which dots may stand.
bool read_data(std::string_view digits, can_frame& frame) noexcept {
  while (!digits.empty()) {
    const auto byte = text::integer<std::uint8_t>(digits.substr(0, 2), kHexadecimal);
    if (digits.size() < 2 || !byte || frame.len == CAN_MAX_DLEN) return false;
    frame.data[frame.len++] = *byte;
    digits.remove_prefix(2);
    if (digits.size() > 1 && digits[0] == '.') digits.remove_prefix(1);
  }
  return true;
}

/// Takes the time at the start of @p rest off it, with its brackets.
std::optional<std::chrono::nanoseconds> take_time(std::string_view& rest) noexcept {
  const std::string_view time = take_word(rest);
  if (!time.starts_with('(') || !time.ends_with(')') || time.find('.') == std::string_view::npos)
    return std::nullopt;
  return text::seconds(time.substr(1, time.size() - 2));
}

constexpr std::string_view kTime = "(SECONDS.MICROSECONDS) at the beginning";
constexpr std::string_view kInterface = "the name of an interface behind the time";
constexpr std::string_view kIdentifier = "an identifier of 3 digits up to 7FF or of 8 up to 1FFFFFFF";

tl::expected<can_frame, std::string_view> read_frame(std::string_view word) noexcept {
  const std::size_t hash = word.find('#');
  if (hash == std::string_view::npos) return Wrong{kFrame};
  const auto identifier = read_identifier(word.substr(0, hash));
  if (!identifier) return Wrong{kIdentifier};
  std::string_view content = word.substr(hash + 1);
  if (content.starts_with('#')) return Wrong{"a classical frame, not one of CAN FD"};
  can_frame frame{};
  frame.can_id = *identifier;
  if (content.starts_with('R')) {
    frame.can_id |= CAN_RTR_FLAG;
    if (!read_length(content.substr(1), frame)) return Wrong{"nothing or a length 0 to 8 behind #R"};
  } else if (!read_data(content, frame)) {
    return Wrong{"at most 8 bytes of two hexadecimal digits behind #"};
  }
  return frame;
}

/// Reads the frame of a line that candump has printed, "605   [8]  40 00 10 ...".
tl::expected<can_frame, std::string_view> read_printed_frame(std::string_view rest) noexcept {
  std::string_view word = take_word(rest);
  if (word == "RX" || word == "TX") {
    for (int flags = 0; flags < 2; ++flags) take_word(rest);
    word = take_word(rest);
  }
  const auto identifier = read_identifier(word);
  if (!identifier) return Wrong{kIdentifier};
  const std::string_view length = take_word(rest);
  const auto bytes = length.size() == 3 ? text::integer<std::uint8_t>(length.substr(1, 1)) : std::nullopt;
  if (!bytes || *bytes > CAN_MAX_DLEN || length.front() != '[' || length.back() != ']')
    return Wrong{"a length [0] to [8] behind the identifier"};
  can_frame frame{};
  frame.can_id = *identifier;
  if (rest.starts_with("remote request")) {
    frame.can_id |= CAN_RTR_FLAG;
    frame.len = *bytes;
    return frame;
  }
  for (unsigned i = 0; i < *bytes; ++i)
    if (const std::string_view byte = take_word(rest); byte.size() != 2 || !read_data(byte, frame))
      return Wrong{"as many bytes of two hexadecimal digits as the length says"};
  if (!rest.empty() && rest.front() != '\'' && rest != "ERRORFRAME") return Wrong{"nothing behind the bytes"};
  return frame;
}

}  // namespace

std::string candump_line(const CandumpLine& line) {
  const auto microseconds = std::chrono::duration_cast<std::chrono::microseconds>(line.at).count();
  constexpr std::int64_t kSecond = 1'000'000;
  std::string text =
      fmt::format("({:010}.{:06}) {} ", microseconds / kSecond, microseconds % kSecond, line.interface);
  const auto end = std::back_inserter(text);
  const can_frame& frame = line.frame;
  if ((frame.can_id & CAN_ERR_FLAG) != 0)
    fmt::format_to(end, "{:08X}#", frame.can_id & (CAN_ERR_MASK | CAN_ERR_FLAG));
  else if ((frame.can_id & CAN_EFF_FLAG) != 0)
    fmt::format_to(end, "{:08X}#", frame.can_id & CAN_EFF_MASK);
  else
    fmt::format_to(end, "{:03X}#", frame.can_id & CAN_SFF_MASK);
  const std::size_t length = std::min<std::size_t>(frame.len, CAN_MAX_DLEN);
  if ((frame.can_id & CAN_RTR_FLAG) == 0)
    for (std::size_t i = 0; i < length; ++i) fmt::format_to(end, "{:02X}", frame.data[i]);
  else if (length == 0)
    text += 'R';
  else
    fmt::format_to(end, "R{}", length);
  text += '\n';
  return text;
}

std::string candump_line(const canopen::Frame& frame, std::chrono::nanoseconds wall_clock,
                         std::string_view interface) {
  CandumpLine line{.at = wall_clock, .interface = interface};
  line.frame.can_id = frame.id | (frame.extended ? CAN_EFF_FLAG : 0U) | (frame.remote ? CAN_RTR_FLAG : 0U);
  line.frame.len = std::min<std::uint8_t>(frame.length, CAN_MAX_DLEN);
  std::ranges::copy(frame.data, line.frame.data);
  return candump_line(line);
}

tl::expected<CandumpLine, std::string_view> read_candump_line(std::string_view text) noexcept {
  skip_blanks(text);
  const auto at = take_time(text);
  if (!at) return Wrong{kTime};
  CandumpLine line{.at = *at, .interface = take_word(text)};
  if (line.interface.empty()) return Wrong{kInterface};
  const auto frame = read_frame(take_word(text));
  if (!frame) return tl::unexpected{frame.error()};
  line.frame = *frame;
  if (!text.empty() && text != "R" && text != "T") return Wrong{"nothing, R or T behind the frame"};
  return line;
}

tl::expected<PrintedLine, std::string_view> read_printed_line(std::string_view text) noexcept {
  if (text.find('#') < text.find('[')) {
    const auto line = read_candump_line(text);
    if (!line) return tl::unexpected{line.error()};
    return PrintedLine{.line = *line};
  }
  skip_blanks(text);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  PrintedLine printed{.has_time = text.starts_with('(')};
  if (printed.has_time) {
    const auto at = take_time(text);
    if (!at) return Wrong{kTime};
    printed.line.at = *at;
  }
  printed.line.interface = take_word(text);
  if (printed.line.interface.empty() || text.empty()) return Wrong{kInterface};
  const auto frame = read_printed_frame(text);
  if (!frame) return tl::unexpected{frame.error()};
  printed.line.frame = *frame;
  return printed;
}

}  // namespace record
