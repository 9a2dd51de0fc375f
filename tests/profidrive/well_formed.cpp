#include "tests/profidrive/well_formed.hpp"

#include <algorithm>
#include <array>

#include "profidrive/parameter/format.hpp"
#include "profidrive/record/record.hpp"

namespace profidrive {
namespace {

constexpr std::size_t kHeader = 4;
constexpr std::uint8_t kWrite = 2, kNegative = 0x80;

/// Takes the entry at the start of @p rest off; what is wrong with it.
std::string take_entry(std::span<const std::uint8_t>& rest, bool writes, bool& has_error) {
  if (rest.size() < 2) return "an entry without a head";
  const FormatRow* const format = find_format(rest[0]);
  if (format == nullptr) return "an unknown format";
  const std::size_t size = std::size_t{rest[1]} * format->size;
  const std::size_t padded = 2 + size + size % 2;
  if (padded > rest.size()) return "an entry that is cut";
  const bool is_error = format->format == Format::Error;
  if (is_error && rest[1] != 1 && rest[1] != 2) return "an error of another length";
  if (is_error && rest[2] != 0) return "an error beyond the list";
  if (!is_error && writes && (format->format != Format::Zero || rest[1] != 0)) return "a write told otherwise";
  if (!is_error && !writes && (!has_values(format->format) || rest[1] == 0)) return "a value that is none";
  if (size % 2 != 0 && rest[padded - 1] != 0) return "a fill byte other than 0";
  has_error = has_error || is_error;
  rest = rest.subspan(padded);
  return {};
}

}  // namespace

std::string broken_rule(std::span<const std::uint8_t> request, std::span<const std::uint8_t> answer) {
  const auto asked = [&](std::size_t place) { return place < request.size() ? request[place] : std::uint8_t{0}; };
  if (answer.size() < kHeader || answer.size() > record::kMostBytes) return "a length that no answer has";
  if (answer[0] != asked(0) || answer[2] != asked(2)) return "another reference or drive object";
  if ((answer[1] | kNegative) != (asked(1) | kNegative)) return "another service";
  const bool is_negative = (answer[1] & kNegative) != 0;
  const bool writes = asked(1) == kWrite;
  std::span<const std::uint8_t> rest = answer.subspan(kHeader);
  bool has_error = false;
  if (is_negative || !writes) {
    for (unsigned i = 0; i < answer[3]; ++i)
      if (const std::string broken = take_entry(rest, writes, has_error); !broken.empty()) return broken;
  }
  if (!rest.empty()) return "bytes behind the entries";
  if (has_error != is_negative) return "a sign that is not that of the entries";
  const bool of_the_whole = is_negative && answer[3] == 1;
  return answer[3] == asked(3) || of_the_whole ? "" : "another number of parameters";
}

std::string broken_rule(const ParameterChannel::Words& request, const ParameterChannel::Words& answer) {
  constexpr unsigned kNotDone = 7;
  /// The identifiers of answers to each request.
  constexpr std::array<std::array<unsigned, 2>, 10> kAnswers{
      {{0, 0}, {1, 2}, {1, 1}, {2, 2}, {3, 3}, {7, 7}, {4, 5}, {4, 4}, {5, 5}, {6, 6}}};
  const std::size_t task = request[0] >> 12;
  const unsigned identifier = answer[0] >> 12;
  if (task == 0) return answer == ParameterChannel::Words{} ? "" : "an answer to nothing";
  if (answer[1] != request[1] || (answer[0] & 0xFFFU) != (request[0] & 0x7FFU)) return "another parameter";
  if (identifier == kNotDone) return answer[2] <= 0xFF && answer[3] == 0 ? "" : "an error beyond the list";
  if (task >= kAnswers.size()) return "an answer to what is no request";
  const auto& fitting = kAnswers[task];
  return std::ranges::count(fitting, identifier) != 0 ? "" : "the answer to another request";
}

}  // namespace profidrive
