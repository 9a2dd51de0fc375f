#pragma once

#include <cstdint>

#include "libcanopen/nmt/state.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace canopen {

/// Sub-index of 1029h for errors of the communication; those of the device profile follow it.
inline constexpr std::uint8_t kCommunicationErrorClass = 1;

/// The NMT state that an error of class @p error_class (sub-index of 1029h) leads to from @p state
/// (CiA 301, 7.5.2.32). Without the object, or outside its values: Pre-operational if @p state is Operational.
NmtState state_after_error(const Dictionary& dictionary, std::uint8_t error_class, NmtState state) noexcept;

}  // namespace canopen
