#pragma once

#include <atomic>
#include <cstdint>

namespace preload {

/// What a hub shows of its bus's link: 1 while the bus is whole, 0 while it is cut.
using LinkWord = const std::atomic<uint32_t>;

/// The word of the hub of CAN socket @p descriptor, which stays mapped; nullptr if its bus ends with it, or if the
/// hub is not to be asked.
LinkWord* link_of(int descriptor) noexcept;

}  // namespace preload
