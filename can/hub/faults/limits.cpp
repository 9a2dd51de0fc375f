#include "can/hub/faults/limits.hpp"

#include <fmt/format.h>

#include "can/hub/faults/effects.hpp"
#include "can/hub/faults/side.hpp"

namespace hub::faults {

namespace {

using injection::Argument;
using injection::EventKind;
using injection::Fault;
using injection::Problem;

std::string in_quotes(std::string_view text) {
  return fmt::format("\"{}\"", text);
}

bool is_frame(const injection::Event& event) noexcept {
  return event.kind == EventKind::Frame;
}

constexpr std::string_view kFrameRule =
    "frame, or frame with an identifier (\"frame 185\"): a bus sees frames alone";

std::optional<Problem> problem_of_when(const injection::When& when) {
  if (when.during)
    return Problem{"while", "nothing: a bus has no state",
                   in_quotes(injection::kStateNames[static_cast<std::size_t>(*when.during)])};
  if (when.event && !is_frame(*when.event))
    return Problem{"event", std::string{kFrameRule}, in_quotes(text_of(*when.event))};
  if (when.until && !is_frame(when.until->event))
    return Problem{"until", fmt::format("a count from 1 and {}", kFrameRule), in_quotes(text_of(*when.until))};
  return std::nullopt;
}

}  // namespace

std::optional<Problem> find_problem(const Fault& fault, const Medium& medium) {
  if (auto problem = problem_of_when(fault.when)) return problem;
  if (fault.value(Argument::Mask) && !fault.value(Argument::Id))
    return Problem{"mask", "an id beside it", fmt::format("\"0x{:X}\"", *fault.value(Argument::Mask))};
  if (const auto members = fault.value(Argument::Members)) {
    const auto wrong = Side::find_wrong(fault.texts[*members]);
    if (wrong) return Problem{"members", std::string{Side::kRule}, in_quotes(*wrong)};
  }
  if (fault.value(Argument::BitRate) && medium.carrier() != nullptr)
    return Problem{"", "a bus of one host for another bit rate", "one over several"};
  if (medium.bit_rate() == 0 && effect_of(fault).needs_bit_rate(fault)) {
    if (fault.value(Argument::Percent))
      return Problem{"", "a bus with a bit rate for a share of its time", "one without"};
    return Problem{"period_us", "a time: a bus without a bit rate takes any number of frames at once", {}};
  }
  return std::nullopt;
}

}  // namespace hub::faults
