#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "drive/messages/cause.hpp"

namespace drive {

/// A message that lasts as long as an input of a block is 0.
template <class Inputs>
struct InputMessage {
  std::uint16_t number;
  bool Inputs::*signal;
  Pulses pulses;
};

/// Remembers which messages inputs have brought.
class InputMessageMonitor {
 public:
  /// Calls @p tell(number, present, before) for each of @p rows whose input brings it now or did so in the last
  /// cycle; @p pulses() says whether the pulses are on.
  template <class Inputs, std::size_t Count, class PulsesOn, class Tell>
  void follow(const std::array<InputMessage<Inputs>, Count>& rows, const Inputs& inputs, const PulsesOn& pulses,
              const Tell& tell) noexcept {
    for (std::size_t i = 0; i < Count; ++i) {
      const unsigned bit = 1U << i;
      const bool before = (told_ & bit) != 0;
      const bool present = !(inputs.*rows[i].signal) && (rows[i].pulses == Pulses::Any || pulses());
      if (!present && !before) continue;
      told_ = present ? told_ | bit : told_ & ~bit;
      tell(rows[i].number, present, before);
    }
  }
  void reset() noexcept { told_ = 0; }

 private:
  unsigned told_ = 0;  // a bit a row
};

/// What the inputs of a drive object acknowledge, and the external faults and alarms that they bring.
class ExternalMessages {
 public:
  struct Inputs {
    using Block = ExternalMessages;

    bool acknowledge_1 = false;       ///< p2103, edge
    bool acknowledge_2 = false;       ///< p2104, edge
    bool acknowledge_3 = false;       ///< p2105, edge
    bool no_external_fault_1 = true;  ///< p2106
    bool no_external_fault_2 = true;  ///< p2107
    bool no_external_fault_3 = true;  ///< p2108
    bool no_external_alarm_1 = true;  ///< p2112

    friend bool operator==(const Inputs&, const Inputs&) = default;
  };
  static constexpr std::array kMessages{
      InputMessage<Inputs>{7850, &Inputs::no_external_alarm_1, Pulses::Any},
      InputMessage<Inputs>{7860, &Inputs::no_external_fault_1, Pulses::Any},
      InputMessage<Inputs>{7861, &Inputs::no_external_fault_2, Pulses::Any},
      InputMessage<Inputs>{7862, &Inputs::no_external_fault_3, Pulses::Any},
  };

  /// Calls @p tell(number, present, before) for each message that an input brings now or brought in the last
  /// cycle.
  template <class Tell>
  void follow(const Tell& tell) noexcept {
    monitor_.follow(
        kMessages, inputs, [] { return true; }, tell);
  }
  /// Whether an acknowledge input has risen since the last call.
  bool acknowledges() noexcept {
    const std::array now{inputs.acknowledge_1, inputs.acknowledge_2, inputs.acknowledge_3};
    bool rises = false;
    for (std::size_t i = 0; i < now.size(); ++i) rises = rises || (now[i] && !before_[i]);
    before_ = now;
    return rises;
  }
  /// What power-off does: no input has come yet.
  void power_off() noexcept {
    inputs = {};
    before_ = {};
    monitor_.reset();
  }

  Inputs inputs{};

 private:
  InputMessageMonitor monitor_;
  std::array<bool, 3> before_{};  // acknowledge inputs
};

}  // namespace drive
