#pragma once

#include <string>
#include <string_view>

#include "can/hub/faults/faults.hpp"

namespace hub::faults {

/// What a member is told (userbus::Operation::Inject).
struct Answer {
  int error = 0;     ///< errno: 0, or EINVAL
  std::string text;  ///< JSON
};

/// Does with @p faults what @p request asks for, a text of JSON; std::bad_alloc. No answer is longer than a
/// message of the bus: what a list has no room for is asked for again, behind the last that was told.
Answer answer(Faults& faults, std::string_view request, canopen::TimePoint now);

}  // namespace hub::faults
