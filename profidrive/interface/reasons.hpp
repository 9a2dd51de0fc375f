#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "profidrive/interface/interface.hpp"

namespace profidrive {

/// Why IF1 does not turn axis @p object (a drive object number) that it commands, each reason a sentence with what
/// to do about it; nothing if its telegram does not command it. For people: it allocates.
std::vector<std::string> reasons(const Interface& interface, std::uint8_t object);

}  // namespace profidrive
