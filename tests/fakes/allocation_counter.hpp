#pragma once

#include <cstdint>

namespace fakes {

/// Calls of operator new since the program began. A test program that links allocation_counter.cpp counts.
std::uint64_t allocations() noexcept;

}  // namespace fakes
