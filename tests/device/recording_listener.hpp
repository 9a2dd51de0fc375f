#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "device/device.hpp"

namespace device {

/// Notes what the unit tells the program around it.
struct RecordingListener final : Listener {
  void on_subscriptions_changed() noexcept override { ++subscription_changes; }
  void on_foreign_frame(std::uint32_t identifier) noexcept override { foreign.push_back(identifier); }
  bool on_bus_restart() noexcept override { return ++bus_restarts, bus_can_be_used; }
  Keeping on_store(std::span<const std::byte> stored) noexcept override {
    if (is_kept) return Keeping::Refused;
    if (is_full) return Keeping::Failed;
    image.assign(stored.begin(), stored.end());
    ++stores;
    return is_slow ? Keeping::Begun : Keeping::Kept;
  }
  void on_restore() noexcept override { ++restores; }
  canopen::TimePoint frame_arrival(canopen::TimePoint now) noexcept override { return now - waited; }

  std::optional<drive::UtcTime> host_time() noexcept override { return ++host_questions, host; }

  std::vector<std::byte> image;  ///< as last stored
  int stores = 0;
  bool is_full = false;  ///< nothing more can be stored
  bool is_slow = false;  ///< the test tells when something is stored
  bool is_kept = false;  ///< what is stored must not be replaced
  int restores = 0;
  canopen::Duration waited{};  ///< of the frame that wakes the unit
  int subscription_changes = 0;
  int bus_restarts = 0;         ///< asked for
  bool bus_can_be_used = true;  ///< as soon as one is asked for
  std::vector<std::uint32_t> foreign;
  std::optional<drive::UtcTime> host{};  ///< what the clock of the host says
  int host_questions = 0;
};

}  // namespace device
