#include "drive/values/object_values.hpp"

#include <array>

#include "drive/object/drive_object.hpp"

namespace drive::object_value {

double no_value(const DriveObject&, std::size_t) noexcept {
  return 0.0;
}

double fixed_value(const DriveObject&, std::size_t index) noexcept {
  constexpr std::array kPercent{0.0,  5.0,   10.0,  20.0,  50.0,   100.0,  150.0, 200.0,
                                -5.0, -10.0, -20.0, -50.0, -100.0, -150.0, -200.0};
  return kPercent[index];
}

void acknowledge(DriveObject& object, std::size_t, double value) noexcept {
  if (value > 0.0) object.acknowledge();
}

}  // namespace drive::object_value
