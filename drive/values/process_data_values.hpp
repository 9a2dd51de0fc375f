#pragma once

#include <cstddef>

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
double interface_state(const DriveObject& object, std::size_t index) noexcept;
double received_double_word(const DriveObject& object, std::size_t place) noexcept;
double received_word(const DriveObject& object, std::size_t place) noexcept;
double sent_double_word(const DriveObject& object, std::size_t place) noexcept;
double sent_word(const DriveObject& object, std::size_t place) noexcept;
double torque(const DriveObject& object, std::size_t index) noexcept;
double velocity(const DriveObject& object, std::size_t index) noexcept;
double vl_velocity(const DriveObject& object, std::size_t index) noexcept;
double word_of_bits(const DriveObject& object, std::size_t index) noexcept;

/// r8890 to r8893: the received word @p Place as bits.
template <std::size_t Place>
double received_bits(const DriveObject& object, std::size_t index) noexcept;
/// r8894, r8895: the word of converter @p Which.
template <std::size_t Which>
double converted_bits(const DriveObject& object, std::size_t index) noexcept;

}  // namespace drive::process_value
