#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "drive/positioning/modes/mode_switching.hpp"
#include "drive/positioning/modes/positioner_settings.hpp"
#include "drive/positioning/positioning_messages.hpp"

namespace drive {

/// Starts that were refused: their alarms stand until the signal that asked is 0 or a start succeeds, that of two
/// signals that exclude each other (A07457) until one of them is 0 or the mode that refused is over.
class Refusals {
 public:
  using Signal = bool PositionerInputs::*;

  /// A start that @p signal asks for is refused with alarm @p message and @p value.
  void refuse(PositioningMessage message, Signal signal, std::uint32_t value = 0) noexcept {
    refused_[place(message)] = {.first = signal, .second = signal, .value = value};
  }
  /// @p first and @p second exclude each other, @p value of A07457; @p active: the mode that refuses.
  void clash(std::uint32_t value, Signal first, Signal second,
             std::optional<PositionerMode> active = std::nullopt) noexcept {
    refused_[place(PositioningMessage::IllegalSignals)] = {
        .first = first, .second = second, .active = active, .value = value};
  }
  /// Whether @p signal is one of two that came together and still exclude each other.
  bool excludes(Signal signal, const PositionerInputs& inputs) const noexcept {
    const Refused& clash = refused_[place(PositioningMessage::IllegalSignals)];
    const bool concerns = clash.first == signal || clash.second == signal;
    return concerns && !clash.active && inputs.*clash.first && inputs.*clash.second;
  }
  /// A start has succeeded.
  void accept() noexcept {
    for (const PositioningMessage message : kMessages)
      if (message != PositioningMessage::IllegalSignals) refused_[place(message)] = {};
  }
  /// Shows the alarms that stand with @p inputs in @p mode.
  void show(const PositionerInputs& inputs, PositionerMode mode, PositioningMessages& messages) noexcept {
    for (const PositioningMessage message : kMessages) {
      Refused& refused = refused_[place(message)];
      if (refused.first != nullptr && !refused.stands(inputs, mode)) refused = {};
      if (refused.first != nullptr || messages.stands(message))
        messages.show(message, refused.first != nullptr, refused.value);
    }
  }
  void clear() noexcept { refused_ = {}; }

 private:
  struct Refused {
    Signal first = nullptr;
    Signal second = nullptr;
    std::optional<PositionerMode> active{};
    std::uint32_t value = 0;

    bool stands(const PositionerInputs& inputs, PositionerMode mode) const noexcept {
      return inputs.*first && inputs.*second && (!active || *active == mode);
    }
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
