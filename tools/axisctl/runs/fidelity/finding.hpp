#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libcanopen/base/time.hpp"
#include "libcanopen/sdo/command.hpp"

namespace runs {

/// What of a unit is compared.
enum class Aspect : std::uint8_t { Answer, AnswerTime, Emergency, State, PdoWord, PdoValue, EventTime, Order };
struct AspectName {
  Aspect aspect;
  std::string_view key;  ///< for programs
  std::string_view text;
};
inline constexpr std::array kAspects{
    AspectName{Aspect::Answer, "sdo_answers", "SDO answers"},
    AspectName{Aspect::AnswerTime, "sdo_times", "times of SDO answers"},
    AspectName{Aspect::Emergency, "emcy", "emergency messages"},
    AspectName{Aspect::State, "nmt_states", "NMT states"},
    AspectName{Aspect::PdoWord, "pdo_words", "words of TPDOs"},
    AspectName{Aspect::PdoValue, "pdo_values", "measured values of TPDOs"},
    AspectName{Aspect::EventTime, "event_times", "times of events"},
    AspectName{Aspect::Order, "order", "order"},
};
[[nodiscard]] constexpr const AspectName& name_of(Aspect aspect) noexcept {
  return kAspects[static_cast<std::size_t>(aspect)];
}

/// How a unit differs from a log.
enum class Nature : std::uint8_t {
  Value,    ///< it says something else
  Refusal,  ///< one refuses what the other does, or with another abort code
  Missing,  ///< it does not say what the log has
  Extra,    ///< it says what the log does not have
  Time,
  Order,
};
/// As the table of known differences names them.
inline constexpr std::array<std::string_view, 6> kNatures{"value", "refusal", "missing", "extra", "time", "order"};

/// A difference of a unit from a log.
struct Finding {
  Aspect aspect = Aspect::Answer;
  Nature nature = Nature::Value;
  std::optional<canopen::sdo::Address> object{};
  canopen::Duration at{};   ///< in the log, since the first frame of the master
  std::uint64_t place = 0;  ///< line of the log; 0: none
  std::string what{};       ///< what it is about
  std::string log{}, run{};
  std::string known{};  ///< "AXD-01: of the device at hand"; empty: it is not known
};

/// What was found of an aspect.
struct Tally {
  std::uint64_t compared = 0, same = 0, within = 0, different = 0, known = 0, missing = 0;
};

/// How long answers took.
struct AnswerTimes {
  canopen::Duration median{}, most_of{}, longest{};  ///< most_of: 99 of 100 were not longer
};

/// How true a unit is to a log.
struct Fidelity {
  std::array<Tally, kAspects.size()> tallies{};
  std::vector<Finding> findings{};  ///< the first ones
  std::uint64_t left_out = 0;       ///< findings behind those
  std::optional<AnswerTimes> log_times{}, run_times{};

  [[nodiscard]] Tally& of(Aspect aspect) noexcept { return tallies[static_cast<std::size_t>(aspect)]; }
  /// Differences that are not known, answers that are missing included.
  [[nodiscard]] std::uint64_t unknown() const noexcept {
    std::uint64_t count = 0;
    for (const Tally& tally : tallies) count += tally.different + tally.missing;
    return count;
  }
};

}  // namespace runs
