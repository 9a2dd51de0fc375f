#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "drive/drive_unit.hpp"

namespace axisd {

/// The BICO inputs of a unit by what they are connected to, as they are at its construction.
class Interconnections {
 public:
  /// An input, and which index or bit of its source it takes.
  struct Input {
    std::uint8_t source_object;
    std::uint16_t source_number;
    std::uint16_t position;
    const drive::DriveObject* object;
    const drive::ParameterRow* row;
    std::size_t index;
  };

  explicit Interconnections(const drive::DriveUnit& unit);

  /// The inputs that take parameter @p number of drive object @p object.
  std::span<const Input> inputs_of(std::uint8_t object, std::uint16_t number) const noexcept;

 private:
  std::vector<Input> inputs_;  ///< by source
};

/// The drive object that @p source of an input of @p owner belongs to; nullptr if @p unit has none.
const drive::DriveObject* object_of(const drive::DriveUnit& unit, const drive::DriveObject& owner,
                                    const drive::BicoSource& source) noexcept;

}  // namespace axisd
