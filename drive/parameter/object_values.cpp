#include "drive/parameter/object_values.hpp"

#include "drive/drive_object.hpp"

namespace drive::object_value {

double no_value(const DriveObject&, std::size_t) noexcept {
  return 0.0;
}

void acknowledge(DriveObject& object, std::size_t, double value) noexcept {
  if (value > 0.0) object.acknowledge();
}

}  // namespace drive::object_value
