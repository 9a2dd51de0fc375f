#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace device {

/// What a request can lead to beyond the drive object that it is about, in the order in which it is done.
enum class FollowUp : std::uint8_t {
  WireMappings,    ///< a mapping has changed: the interconnections follow
  RestoreObject,   ///< p0970 has reset the drive object that is the argument
  ShowMessages,    ///< faults or alarms may have come or gone
  PlanBusRestart,  ///< p8608 was written; argument 1: a restart is wanted now
  RestartUnit,     ///< p0009 was written: when it is left, another p8848 than that in force starts the unit again
  CommandNode,     ///< p8685: the NMT command that is the argument
  Restore,         ///< 1011h, p0976: the parameters of the group that is the argument
  ResetNode,       ///< p0972, p0976
  Count
};

/// The work that waits until the answer to a request is out. What is asked for twice is done once, as it was asked
/// for last.
class FollowUps {
 public:
  /// One piece of work.
  struct Item {
    FollowUp what;
    std::uint8_t argument;

    friend bool operator==(const Item&, const Item&) = default;
  };

  void add(FollowUp what, std::uint8_t argument = 0) noexcept {
    pending_ |= bit_of(what);
    arguments_[static_cast<std::size_t>(what)] = argument;
  }
  /// It has been done on another occasion.
  void drop(FollowUp what) noexcept { pending_ &= ~bit_of(what); }
  bool is_empty() const noexcept { return pending_ == 0; }
  /// What is to be done next, and no longer waits; not to be called if nothing does.
  Item take() noexcept {
    const auto first = static_cast<std::size_t>(std::countr_zero(pending_));
    pending_ &= pending_ - 1;
    return {static_cast<FollowUp>(first), arguments_[first]};
  }

 private:
  static constexpr std::size_t kCount = static_cast<std::size_t>(FollowUp::Count);
  static constexpr std::uint32_t bit_of(FollowUp what) noexcept { return 1U << static_cast<unsigned>(what); }

  std::uint32_t pending_ = 0;  ///< a bit for each FollowUp
  std::array<std::uint8_t, kCount> arguments_{};
};

}  // namespace device
