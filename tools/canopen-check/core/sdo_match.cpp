#include "tools/canopen-check/core/sdo_match.hpp"

#include <algorithm>
#include <array>

namespace conformance {
namespace {

constexpr std::uint8_t kAbort = 0x80;

/// Command bytes under a mask.
struct Pattern {
  std::uint8_t mask = 0, value = 0;

  [[nodiscard]] constexpr bool matches(std::uint8_t byte) const noexcept { return (byte & mask) == value; }
};

/// A request of the client and an answer of the server to it (CiA 301, 7.2.4.3.3 to 7.2.4.3.16).
struct Rule {
  Pattern request, answer;
  bool named = false;  ///< both name the entry
};
constexpr std::uint8_t kSpecifier = 0xE0, kSpecifierAndEnd = 0xE1, kSpecifierAndSubcommand = 0xE3;
constexpr std::array kRules{
    Rule{{kSpecifier, 0x40}, {kSpecifier, 0x40}, true},                     // initiate upload
    Rule{{kSpecifier, 0x60}, {kSpecifier, 0x00}},                           // upload segment
    Rule{{kSpecifier, 0x20}, {kSpecifier, 0x60}, true},                     // initiate download
    Rule{{kSpecifier, 0x00}, {kSpecifier, 0x20}},                           // download segment
    Rule{{kSpecifierAndSubcommand, 0xA0}, {kSpecifierAndEnd, 0xC0}, true},  // initiate block upload
    Rule{{kSpecifierAndSubcommand, 0xA0}, {kSpecifier, 0x40}, true},  // the same, switched to another protocol
    Rule{{kSpecifierAndSubcommand, 0xA3}, {}},                        // its start: any segment
    Rule{{kSpecifierAndSubcommand, 0xA2}, {}},                        // its confirmation: any segment, or the end
    Rule{{kSpecifierAndEnd, 0xC0}, {kSpecifierAndSubcommand, 0xA0}, true},  // initiate block download
    Rule{{kSpecifierAndEnd, 0xC1}, {kSpecifierAndSubcommand, 0xA1}},        // end block download
};
/// What the server answers to the last segment of a sub-block.
constexpr Pattern kSubBlockConfirmed{kSpecifierAndSubcommand, 0xA2};

}  // namespace

Multiplexor multiplexor_of(const canopen::Frame& frame) noexcept {
  return {.index = static_cast<std::uint16_t>(frame.data[1] | frame.data[2] << 8U), .sub_index = frame.data[3]};
}

bool is_abort(const canopen::Frame& frame) noexcept {
  return frame.length == frame.data.size() && frame.data[0] == kAbort;
}

bool names_its_entry(const canopen::Frame& request) noexcept {
  return std::ranges::any_of(
      kRules, [&](const Rule& rule) { return rule.named && rule.request.matches(request.data[0]); });
}

SdoMatch::SdoMatch(const canopen::Frame& request, std::optional<Multiplexor> transfer) noexcept
    : request_{request}, entry_{names_its_entry(request) ? multiplexor_of(request) : transfer} {}

SdoMatch SdoMatch::sub_block(std::optional<Multiplexor> transfer) noexcept {
  return SdoMatch{transfer};
}

bool SdoMatch::fits(const canopen::Frame& answer) const noexcept {
  if (is_abort(answer)) return !entry_ || multiplexor_of(answer) == *entry_;
  if (!request_) return kSubBlockConfirmed.matches(answer.data[0]);
  return std::ranges::any_of(kRules, [&](const Rule& rule) {
    return rule.request.matches(request_->data[0]) && rule.answer.matches(answer.data[0]) &&
           (!rule.named || multiplexor_of(answer) == multiplexor_of(*request_));
  });
}

bool SdoMatch::stands_in(const canopen::Frame& answer) const noexcept {
  return !is_abort(answer) || !request_ || !names_its_entry(*request_);
}

}  // namespace conformance
