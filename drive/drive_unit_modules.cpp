// The function modules that the control unit gives its axes.
#include "drive/drive_unit.hpp"

namespace drive {
namespace {

constexpr std::uint16_t kModules = 108;  // p0108, of the drive objects in the order of their numbers

}  // namespace

/// p0108 shows what the configuration alone gives, whatever was written or saved.
void DriveUnit::follow_function_modules() noexcept {
  for (Axis& axis : axes_) {
    const std::size_t index = std::size_t{axis.number()} - kControlUnitNumber;
    const auto wanted = static_cast<function_module::Set>(control_unit_.read(kModules, index).value_or(0.0));
    axis.set_function_modules(wanted);
    const function_module::Set shown =
        (wanted & ~function_module::kPositioning) | function_module::configured(axis.context().axis);
    if (shown != wanted) static_cast<void>(control_unit_.load(kModules, index, shown));
  }
  on_wiring_changed();  // inputs come and go with their module
}

}  // namespace drive
