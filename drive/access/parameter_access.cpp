#include "drive/access/parameter_access.hpp"

namespace drive {
namespace {

/// p0927: a bit for each door through which may be written.
constexpr std::uint16_t kAuthority = 927;

std::uint32_t authority_bit(Door door) noexcept {
  constexpr std::uint32_t kAcyclic = 0x1, kChannel = 0x8;
  return door == Door::Record ? kAcyclic : kChannel;
}

/// Whoever has lost the authority gets it back through any door.
bool has_authority(const FoundParameter& parameter, Door door) noexcept {
  if (door == Door::Any || parameter.row().number == kAuthority) return true;
  const double all = row_of(DataType::U16).highest;
  const auto doors = static_cast<std::uint32_t>(parameter.object.read(kAuthority).value_or(all));
  return (doors & authority_bit(door)) != 0;
}

tl::unexpected<ParameterError> refused(const FoundParameter& parameter, Refusal reason) noexcept {
  return tl::unexpected{ParameterError{reason, parameter.row().number, &parameter.row()}};
}

}  // namespace

tl::expected<FoundParameter, ParameterError> ParameterAccess::find(
    const ParameterAddress& address) const noexcept {
  DriveObject* const object = unit_.object(address.object);
  if (object == nullptr) return tl::unexpected{ParameterError{Refusal::NoDriveObject, address.number, nullptr}};
  return object->parameter(address.number, address.index).map([&](const PlacedRow* placed) {
    return FoundParameter{*object, *placed, address.index};
  });
}

ParameterValue ParameterAccess::read(const FoundParameter& parameter) noexcept {
  listener_.on_access();
  return DriveUnit::read(parameter.object, parameter.placed, parameter.index);
}

tl::expected<ParameterValue, ParameterError> ParameterAccess::read(const ParameterAddress& address) noexcept {
  return find(address).map([this](const FoundParameter& parameter) { return read(parameter); });
}

/// The state of the drive object aside.
std::optional<Refusal> ParameterAccess::door_refusal(const FoundParameter& parameter, Door door) const noexcept {
  if (!parameter.row().is_writable()) return Refusal::ReadOnly;
  if (!has_authority(parameter, door)) return Refusal::NoAuthority;
  return listener_.is_locked() ? std::optional<Refusal>{Refusal::NotNow} : std::nullopt;
}

std::optional<Refusal> ParameterAccess::write_refusal(const FoundParameter& parameter, Door door) const noexcept {
  const auto reason = door_refusal(parameter, door);
  return reason ? reason : parameter.object.state_refusal(parameter.row());
}

tl::expected<void, ParameterError> ParameterAccess::write(const FoundParameter& parameter,
                                                          const TransferredValue& value, Door door) noexcept {
  const ParameterRow& row = parameter.row();
  if (row.is_writable() && !fits(value, row)) return refused(parameter, Refusal::WrongType);
  return write(parameter, decode({row.type, value.bits}), door);
}

tl::expected<void, ParameterError> ParameterAccess::write(const FoundParameter& parameter, double value,
                                                          Door door) noexcept {
  if (const auto reason = door_refusal(parameter, door)) return refused(parameter, *reason);
  listener_.on_access();
  const double before = observer_ != nullptr ? parameter.object.value(parameter.placed, parameter.index) : 0.0;
  auto written = unit_.write(parameter.object, parameter.placed, parameter.index, value);
  if (!written) return written;
  listener_.on_written(parameter.object.number(), parameter.row().number);
  if (observer_ != nullptr) observer_->on_write(parameter, before, value);
  return written;
}

}  // namespace drive
