#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libcanopen/base/frame.hpp"

namespace sdo_test {

/// One indexed parameter of a drive object as tests/drive/data/parameters.csv states it.
struct ListedParameter {
  std::string name;        ///< p1120[0]
  std::uint16_t object;    ///< its index in the area from 2000h on
  std::uint8_t sub_index;  ///< its index
  unsigned size;           ///< bytes
};

/// The parameters of the control unit, or of a servo axis, that the default areas show: number below 10000, index
/// below 256.
std::vector<ListedParameter> listed_parameters(bool of_the_control_unit);

/// Whether the parameter at @p object is not in the list but named by what else is known of the real unit.
bool is_named_elsewhere(std::uint16_t object);

/// The SDO server of a drive object and where its client is in the list of parameters.
struct ServerTransfer {
  std::uint32_t request;   ///< identifier
  std::uint32_t response;  ///< identifier
  std::vector<ListedParameter> parameters;
  std::size_t next = 0;

  /// The upload request for the next parameter, nothing at the end of the list.
  std::optional<canopen::Frame> request_frame() const;
  /// Judges @p answer to that request, and goes on to the next one.
  void take_answer(const canopen::Frame& answer);
};

}  // namespace sdo_test
