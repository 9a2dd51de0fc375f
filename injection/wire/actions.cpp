#include "injection/wire/actions.hpp"

#include <algorithm>
#include <array>
#include <chrono>

#include "libcanopen/base/little_endian.hpp"
#include "libcanopen/base/nmt_state.hpp"

namespace injection::actions {
namespace {

constexpr std::uint8_t kGuardToggle = 0x80;

std::array<canopen::NmtState, 3> constexpr kNmtStates{
    canopen::NmtState::Stopped, canopen::NmtState::PreOperational, canopen::NmtState::Operational};

}  // namespace

bool fits_sent(const Passing& passing, const Fault&) noexcept {
  return passing.is_sent;
}

bool fits_received(const Passing& passing, const Fault&) noexcept {
  return !passing.is_sent;
}

bool fits_pdo(const Passing& passing, const Fault& fault) noexcept {
  return fault.allows(Argument::Pdo, passing.role.number);
}

bool fits_end_of_emergency(const Passing& passing, const Fault&) noexcept {
  return canopen::load<std::uint16_t>(passing.frame.data.data()) == 0;
}

void drop(Passing& passing, Loaded&, const device::Device&) noexcept {
  passing.is_dropped = true;
}

void delay(Passing& passing, Loaded& loaded, const device::Device&) noexcept {
  passing.delay += std::chrono::milliseconds{loaded.value(Argument::DelayMs).value_or(0)};
}

void double_it(Passing& passing, Loaded&, const device::Device&) noexcept {
  ++passing.copies;
}

void shorten(Passing& passing, Loaded& loaded, const device::Device&) noexcept {
  std::uint8_t& length = passing.frame.length;
  const std::uint8_t one_less = length != 0 ? static_cast<std::uint8_t>(length - 1) : std::uint8_t{0};
  length = static_cast<std::uint8_t>(
      std::min<std::uint32_t>(loaded.fault.value_or(Argument::Length, one_less), length));
}

/// What the first frame of its identifier that was hit says.
void freeze(Passing& passing, Loaded& loaded, const device::Device&) noexcept {
  const auto kept = std::ranges::find_if(loaded.kept, [&](const canopen::Frame& frame) {
    return canopen::identifier_of(frame) == canopen::identifier_of(passing.frame);
  });
  if (kept != loaded.kept.end())
    passing.frame.data = kept->data;
  else if (loaded.kept.size() < loaded.kept.capacity())
    loaded.kept.push_back(passing.frame);
}

void change_state(Passing& passing, Loaded& loaded, const device::Device&) noexcept {
  const auto state = kNmtStates[loaded.value(Argument::NmtState).value_or(0)];
  passing.frame.data[0] =
      static_cast<std::uint8_t>((passing.frame.data[0] & kGuardToggle) | static_cast<std::uint8_t>(state));
}

void flip_guard_toggle(Passing& passing, Loaded&, const device::Device&) noexcept {
  passing.frame.data[0] ^= kGuardToggle;
}

}  // namespace injection::actions
