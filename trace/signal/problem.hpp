#pragma once

#include <cstdint>
#include <string>

namespace trace {

/// Why a trace cannot be as it was asked for.
struct Problem {
  enum class Kind : std::uint8_t {
    Malformed,  ///< it is not what it should be
    NotFound,   ///< the unit has nothing of that name
    TooMuch,    ///< more than a trace takes
  };

  Kind kind;
  std::string key;       ///< of the settings: "trigger.level"
  std::string expected;  ///< what there should have been
};

}  // namespace trace
