#pragma once

#include <cstdint>

#include "drive/drive_unit.hpp"

namespace drive {

/// What the connector input of @p own that holds @p packed brings to process data in which @p full is 100 %. A
/// quantity is taken relative to its reference (p2000 to p2007 of the drive object that it comes from), a number
/// without unit as it is, process data relative to their own 100 %. An input that is not connected brings 0.
double connected_value(const DriveUnit& unit, const DriveObject& own, std::uint32_t packed, double full) noexcept;

/// Whether the binector input of @p own that holds @p packed gets 1.
bool connected_bit(const DriveUnit& unit, const DriveObject& own, std::uint32_t packed) noexcept;

/// The drive object that the connector or binector input of @p own with @p source is connected to, or nullptr.
const DriveObject* connected_object(const DriveUnit& unit, const DriveObject& own,
                                    const BicoSource& source) noexcept;

}  // namespace drive
