#pragma once

#include <cstddef>

#include "drive/base/process_data_image.hpp"

namespace drive {
class DriveObject;
}

/// What parameters show of the process data of a drive object, as numbers of their own types.
namespace drive::process_value {

/// r8854.
double board_state(const DriveObject& object, std::size_t index) noexcept;
double controlword(const DriveObject& object, std::size_t index) noexcept;
double free_double_word(const DriveObject& object, std::size_t index) noexcept;
double free_word(const DriveObject& object, std::size_t index) noexcept;
double torque(const DriveObject& object, std::size_t index) noexcept;
double velocity(const DriveObject& object, std::size_t index) noexcept;
double vl_velocity(const DriveObject& object, std::size_t index) noexcept;

/// r2043: the state of IF1 as bits.
double if1_state(const DriveObject& object, std::size_t index) noexcept;

/// Of IF1 (r2050, r2053, r2060, r2063, r2089) and IF2 (r8843 to r8889).
template <PzdInterface Interface>
double interface_state(const DriveObject& object, std::size_t index) noexcept;
template <PzdInterface Interface>
double received_word(const DriveObject& object, std::size_t place) noexcept;
template <PzdInterface Interface>
double received_double_word(const DriveObject& object, std::size_t place) noexcept;
template <PzdInterface Interface>
double sent_word(const DriveObject& object, std::size_t place) noexcept;
template <PzdInterface Interface>
double sent_double_word(const DriveObject& object, std::size_t place) noexcept;
template <PzdInterface Interface>
double word_of_bits(const DriveObject& object, std::size_t index) noexcept;

/// r2090 to r2093, r8890 to r8893: the received word @p Place as bits.
template <PzdInterface Interface, std::size_t Place>
double received_bits(const DriveObject& object, std::size_t index) noexcept;
/// r2094, r2095, r8894, r8895: the word of converter @p Which.
template <PzdInterface Interface, std::size_t Which>
double converted_bits(const DriveObject& object, std::size_t index) noexcept;

}  // namespace drive::process_value
