#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace unit {

/// What a request can lead to beyond the drive object that it is about, in the order in which it is done.
enum class FollowUp : std::uint8_t {
  RestoreObject,  ///< p0970 has reset the drive object that is the argument
  ShowMessages,   ///< faults or alarms may have come or gone
  RestartUnit,    ///< p0009 was written: when it is left, another p8848 than that in force starts the unit again
  Restore,        ///< 1011h, p0976: the parameters of the group that is the argument
  Reset,          ///< p0972, p0976: off and on again
  Count
};

/// The work that waits until the answer to a request is out. What is asked for twice is done once, as it was asked
/// for last. @p Kind is an enumeration of the work in the order in which it is done, ended by Count.
template <class Kind>
class FollowUps {
 public:
  /// One piece of work.
  struct Item {
    Kind what;
    std::uint8_t argument;

    friend bool operator==(const Item&, const Item&) = default;
  };

  void add(Kind what, std::uint8_t argument = 0) noexcept {
    pending_ |= bit_of(what);
    arguments_[static_cast<std::size_t>(what)] = argument;
  }
  /// It has been done on another occasion.
  void drop(Kind what) noexcept { pending_ &= ~bit_of(what); }
  bool is_empty() const noexcept { return pending_ == 0; }
  /// What is to be done next, and no longer waits; not to be called if nothing does.
  Item take() noexcept {
    const auto first = static_cast<std::size_t>(std::countr_zero(pending_));
    pending_ &= pending_ - 1;
    return {static_cast<Kind>(first), arguments_[first]};
  }

 private:
  static constexpr std::size_t kCount = static_cast<std::size_t>(Kind::Count);
  static_assert(kCount <= 32);
  static constexpr std::uint32_t bit_of(Kind what) noexcept { return 1U << static_cast<unsigned>(what); }

  std::uint32_t pending_ = 0;  ///< a bit for each of the kind
  std::array<std::uint8_t, kCount> arguments_{};
};

}  // namespace unit
