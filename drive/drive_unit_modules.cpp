// The function modules that the control unit gives its axes.
#include "drive/drive_unit.hpp"

namespace drive {
namespace {

constexpr std::uint16_t kModules = 108;  // p0108, of the drive objects in the order of their numbers

}  // namespace

void DriveUnit::follow_function_modules() noexcept {
  for (Axis& axis : axes_) {
    const double wanted = control_unit_.read(kModules, axis.number() - kControlUnitNumber).value_or(0.0);
    axis.set_function_modules(static_cast<function_module::Set>(wanted));
  }
  on_wiring_changed();  // inputs come and go with their module
}

}  // namespace drive
