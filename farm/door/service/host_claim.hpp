#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace farm {

/// Which of several doors that use one name of a host has it. Who comes while another one has it waits until that
/// is gone; of two that have it, as they came at once or could not hear each other, the one with the lower number
/// keeps it. Time is told.
class HostClaim {
 public:
  using Time = std::chrono::nanoseconds;  ///< since any zero

  /// One that has not been heard for so long is gone.
  static constexpr std::chrono::seconds kPatience{2};

  /// @p instance is the own number.
  explicit HostClaim(std::uint64_t instance) noexcept : instance_{instance} {}

  /// The door with the number @p instance uses the name, too; it may be the own one.
  void hear(std::uint64_t instance, Time now) noexcept;
  /// Whether this door may have the name.
  [[nodiscard]] bool is_free(Time now) const noexcept;
  /// This door has it from now on, or gives it up.
  void take() noexcept { has_ = true; }
  void give_up() noexcept { has_ = false; }
  [[nodiscard]] bool has() const noexcept { return has_; }

 private:
  std::uint64_t instance_;
  bool has_ = false;
  std::optional<Time> other_{};  ///< when one was heard last that goes before this one
};

}  // namespace farm
