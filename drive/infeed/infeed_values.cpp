#include "drive/values/infeed_values.hpp"

#include <array>
#include <cstdint>
#include <span>

#include "drive/infeed/infeed.hpp"

namespace drive::infeed_value {
namespace {

struct Bit {
  unsigned number;
  bool on;
};

double word(std::span<const Bit> bits) noexcept {
  std::uint32_t value = 0;
  for (const Bit& bit : bits) value |= static_cast<std::uint32_t>(bit.on) << bit.number;
  return value;
}

/// What r0002 shows in a state while something holds; of several the last one.
struct Display {
  State state;
  bool (*holds)(const Infeed& infeed);
  double code;
};
bool always(const Infeed&) noexcept {
  return true;
}
constexpr std::array kDisplays{
    Display{State::OperationEnabled, always, 0.0},
    Display{State::SwitchedOn, always, 21.0},
    Display{State::ReadyToSwitchOn, always, 31.0},
    Display{State::SwitchOnDisabled, always, 41.0},  // ON is still set
    Display{State::SwitchOnDisabled, [](const Infeed& infeed) { return infeed.inputs().has_off2(); }, 42.0},
    Display{State::Fault, always, 45.0},
    Display{State::SwitchOnDisabled, [](const Infeed& infeed) { return infeed.is_inhibited(); }, 46.0},
    Display{State::NotReadyToSwitchOn, always, 70.0},
    Display{State::SwitchedOn, [](const Infeed& infeed) { return !infeed.has_link(); }, 200.0},
};

}  // namespace

double operating_display(const Infeed& infeed, std::size_t) noexcept {
  double code = 0.0;
  for (const Display& display : kDisplays)
    if (display.state == infeed.state() && display.holds(infeed)) code = display.code;
  return code;
}

double dc_voltage(const Infeed& infeed, std::size_t) noexcept {
  return infeed.dc_voltage();
}

double coupling(const Infeed& infeed, std::size_t) noexcept {
  return word(std::array{Bit{0, infeed.operates()}, Bit{1, infeed.is_connected()}});
}

double sequence_control(const Infeed& infeed, std::size_t) noexcept {
  const InfeedInputs& inputs = infeed.inputs();
  return word(std::array{Bit{0, inputs.on}, Bit{1, !inputs.has_off2()}, Bit{3, inputs.enable_operation}});
}

double sequence_status(const Infeed& infeed, std::size_t) noexcept {
  const State state = infeed.state();
  const bool connected = infeed.is_connected();
  return word(std::array{Bit{0, state == State::ReadyToSwitchOn || connected}, Bit{1, connected},
                         Bit{2, infeed.operates()}, Bit{4, !infeed.inputs().has_off2()},
                         Bit{6, state == State::SwitchOnDisabled || state == State::Fault}, Bit{9, true},
                         Bit{11, connected && infeed.has_link()}, Bit{12, connected}});
}

}  // namespace drive::infeed_value
