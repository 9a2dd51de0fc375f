#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "drive/positioning/modes/positioner_settings.hpp"
#include "drive/positioning/positioning_messages.hpp"

namespace drive {

/// Starts that were refused: their alarms stand until the signal that asked is 0 or a start succeeds, that of two
/// signals that exclude each other (A07457) until one of them is 0.
class Refusals {
 public:
  using Signal = bool PositionerInputs::*;

  /// A start that @p signal asks for is refused with alarm @p message and @p value.
  void refuse(PositioningMessage message, Signal signal, std::uint32_t value = 0) noexcept {
    refused_[place(message)] = {.first = signal, .second = signal, .value = value};
  }
  /// @p first and @p second exclude each other, @p value of A07457.
  void clash(std::uint32_t value, Signal first, Signal second) noexcept {
    refused_[place(PositioningMessage::IllegalSignals)] = {.first = first, .second = second, .value = value};
  }
  /// A start has succeeded.
  void accept() noexcept {
    for (const PositioningMessage message : kMessages)
      if (message != PositioningMessage::IllegalSignals) refused_[place(message)] = {};
  }
  /// Shows the alarms that stand with @p inputs.
  void show(const PositionerInputs& inputs, PositioningMessages& messages) noexcept {
    for (const PositioningMessage message : kMessages) {
      Refused& refused = refused_[place(message)];
      if (refused.first != nullptr && !(inputs.*refused.first && inputs.*refused.second)) refused = {};
      if (refused.first != nullptr || messages.stands(message))
        messages.show(message, refused.first != nullptr, refused.value);
    }
  }
  void clear() noexcept { refused_ = {}; }

 private:
  struct Refused {
    Signal first = nullptr;
    Signal second = nullptr;
    std::uint32_t value = 0;
  };
  static constexpr std::array kMessages{
      PositioningMessage::IllegalSignals,      PositioningMessage::NotReferenced,
      PositioningMessage::NoSuchBlock,         PositioningMessage::IntermediateStopMissing,
      PositioningMessage::RejectMissing,       PositioningMessage::EnableNotPossible,
      PositioningMessage::FixedStopNotPossible};
  static constexpr std::size_t place(PositioningMessage message) noexcept {
    std::size_t at = 0;
    while (kMessages[at] != message) ++at;
    return at;
  }

  std::array<Refused, kMessages.size()> refused_{};
};

}  // namespace drive
