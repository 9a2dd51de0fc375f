#pragma once

#include <vector>

#include "cia402/setup/configuration.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace cia402 {

/// The dictionary of a device: the rows of the catalogue, with the values that follow from identity and motors.
struct DeviceObjects {
  explicit DeviceObjects(const Configuration& configuration);

  std::vector<canopen::EntryDescription> rows;
  canopen::Dictionary dictionary;

 private:
  static std::vector<canopen::EntryDescription> rows_of(const Configuration& configuration);
};

}  // namespace cia402
