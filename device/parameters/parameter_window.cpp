#include "device/parameters/parameter_window.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "device/objects/abort_codes.hpp"
#include "device/objects/object_index.hpp"

namespace device {
namespace {

using canopen::AbortCode;
using canopen::ObjectPlace;

constexpr std::uint16_t kFirstObject = 0x2000;
constexpr std::uint16_t kLastObject = 0x470F;
constexpr unsigned kNumbersInWindow = 10000;
constexpr std::size_t kIndicesInWindow = 256;

/// p8630, and what its indices select.
constexpr std::uint16_t kWindow = 8630;
constexpr std::uint16_t kWindowObject = kFirstObject + kWindow;
constexpr std::size_t kDriveObject = 0, kIndexRange = 1, kNumberRange = 2;

/// What the servers of the drive objects show besides parameters.
constexpr std::array kCommonObjects{object::kDeviceType, object::kErrorRegister, object::kIdentity};

constexpr std::uint8_t kDefaultServer = 0;

constexpr bool is_parameter(std::uint16_t index) noexcept {
  return index >= kFirstObject && index <= kLastObject;
}

/// @p bytes, the least significant first, as a number.
std::uint32_t number_in(std::span<const std::uint8_t> bytes) noexcept {
  std::uint32_t number = 0;
  for (std::size_t i = bytes.size(); i > 0; --i) number = number << 8 | bytes[i - 1];
  return number;
}

}  // namespace

/// 1201h belongs to the control unit, the others to the axes in their order: an infeed has none.
std::uint8_t ParameterWindow::object_of(std::uint8_t server) const noexcept {
  if (server <= drive::kControlUnitNumber) return server;
  return static_cast<std::uint8_t>(server - drive::kFirstAxisNumber + unit_.first_axis());
}

ObjectPlace ParameterWindow::place_of(std::uint8_t server, std::uint16_t index) const noexcept {
  const bool is_default = server == kDefaultServer;
  if (is_parameter(index)) {
    const bool shown =
        is_default ? index == kWindowObject || is_open() : unit_.object(object_of(server)) != nullptr;
    return shown ? ObjectPlace::Application : ObjectPlace::Nowhere;
  }
  if (is_default) return ObjectPlace::Dictionary;
  const bool is_common = std::ranges::find(kCommonObjects, index) != kCommonObjects.end();
  return is_common ? ObjectPlace::Dictionary : ObjectPlace::Nowhere;
}

std::uint16_t ParameterWindow::window(std::size_t index) const noexcept {
  return static_cast<std::uint16_t>(unit_.object(drive::kControlUnitNumber)->read(kWindow, index).value_or(0.0));
}

/// Whether p8630[0] names a drive object.
bool ParameterWindow::is_open() const noexcept {
  const std::uint16_t object = window(kDriveObject);
  return object <= std::numeric_limits<std::uint8_t>::max() &&
         unit_.object(static_cast<std::uint8_t>(object)) != nullptr;
}

canopen::Result<ParameterWindow::Target> ParameterWindow::target(std::uint8_t server, std::uint16_t index,
                                                                 std::uint8_t sub_index) const noexcept {
  const auto number = static_cast<std::uint16_t>(index - kFirstObject);
  if (server != kDefaultServer) return Target{object_of(server), number, sub_index};
  if (index == kWindowObject) return Target{drive::kControlUnitNumber, kWindow, sub_index};
  const unsigned far = number + kNumbersInWindow * window(kNumberRange);
  if (far > std::numeric_limits<std::uint16_t>::max()) return canopen::refuse(AbortCode::NoObject);
  return Target{static_cast<std::uint8_t>(window(kDriveObject)), static_cast<std::uint16_t>(far),
                sub_index + kIndicesInWindow * window(kIndexRange)};
}

std::optional<ParameterWindow::Target> ParameterWindow::parameter_at(std::uint8_t server, std::uint16_t index,
                                                                     std::uint8_t sub_index) const noexcept {
  if (place_of(server, index) != ObjectPlace::Application) return std::nullopt;
  const auto found = target(server, index, sub_index);
  return found ? std::optional{*found} : std::nullopt;
}

canopen::Result<std::size_t> ParameterWindow::read(std::uint8_t server, std::uint16_t index,
                                                   std::uint8_t sub_index,
                                                   std::span<std::uint8_t, 8> value) noexcept {
  const auto wanted = target(server, index, sub_index);
  if (!wanted) return canopen::refuse(wanted.error());
  const auto found = access_.read(*wanted);
  if (!found) return canopen::refuse(abort_code(found.error().reason));
  for (std::size_t i = 0; i < sizeof found->bits; ++i) value[i] = static_cast<std::uint8_t>(found->bits >> 8 * i);
  return std::size_t{drive::row_of(found->type).size};
}

canopen::Result<void> ParameterWindow::write(std::uint8_t server, std::uint16_t index, std::uint8_t sub_index,
                                             std::span<const std::uint8_t> value, bool sized) noexcept {
  const auto wanted = target(server, index, sub_index);
  if (!wanted) return canopen::refuse(wanted.error());
  const auto found = access_.find(*wanted);
  if (!found) return canopen::refuse(abort_code(found.error().reason));
  const std::size_t own_size = drive::row_of(found->row().type).size;
  const bool has_own_size = value.size() == own_size || (!sized && value.size() > own_size);
  const std::size_t size = has_own_size ? own_size : value.size();
  const auto written = access_.write(*found, {.bits = number_in(value.first(size)), .size = size});
  if (!written) return canopen::refuse(abort_code(written.error().reason));
  return {};
}

}  // namespace device
