#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "injection/language/argument.hpp"
#include "injection/language/event.hpp"
#include "injection/language/state.hpp"
#include "libcanopen/base/time.hpp"

namespace injection {

/// How long a fault of a kind takes.
enum class Nature : std::uint8_t {
  Each,    ///< an event is hit: a frame, a cycle
  Moment,  ///< it happens and is over
  Lasting  ///< it holds from then on
};

/// A kind of fault, as a row of a table says it.
struct Kind {
  std::string_view name;  ///< "sdo.late"
  std::string_view summary;
  Nature nature;
  EventKind own;  ///< what it hits; of the other natures: what `every` counts if the fault names no event
  std::span<const ArgumentUse> arguments;
};

/// When a fault happens. Everything is optional; without anything it happens at every opportunity from now on.
struct When {
  std::optional<Event> event{};          ///< what `after` counts; without: the opportunities of the fault itself
  std::uint32_t after = 0;               ///< so many of them pass first
  std::uint32_t every = 1;               ///< of the opportunities every so many'th is hit
  std::optional<std::uint32_t> times{};  ///< hits, then it is over
  std::optional<double> probability{};   ///< of a hit, 0 to 1
  std::uint64_t seed = 0;                ///< of the draws
  std::optional<State> during{};         ///< `while`: no opportunity in other states
  std::optional<Milestone> until{};      ///< over after so many events that it has not hit
  std::optional<canopen::Duration> lasting{};  ///< `for_ms`: over so long after it has become active; of
                                               ///< Nature::Lasting: the end of each hit
};

/// A fault as somebody wants it.
struct Fault {
  const Kind* kind = nullptr;
  std::array<std::optional<std::uint32_t>, kArguments> arguments{};
  std::vector<std::string> texts{};  ///< values of arguments that are texts
  When when{};

  std::optional<std::uint32_t> value(Argument argument) const noexcept {
    return arguments[static_cast<std::size_t>(argument)];
  }
  std::uint32_t value_or(Argument argument, std::uint32_t absent) const noexcept {
    return value(argument).value_or(absent);
  }
  /// Whether @p argument was not given, or is @p value.
  bool allows(Argument argument, std::uint32_t value) const noexcept { return value_or(argument, value) == value; }
};

}  // namespace injection
