#pragma once

#include "libcanopen/base/export.hpp"
#include "libcanopen/pdo/parameters.hpp"

namespace canopen {

/// Takes received process data to the dictionary (CiA 301, 7.2.2): event-driven RPDOs at once, synchronous ones
/// with the next SYNC.
class CANOPEN_EXPORT ReceivePdos final : public PdoParameters::Listener {
 public:
  /// Uses the timers @p first_timer .. first_timer + timers_for(dictionary) - 1.
  ReceivePdos(Context& context, std::size_t first_timer);
  /// Timers that the RPDOs of @p dictionary need.
  static std::size_t timers_for(const Dictionary& dictionary) noexcept;

  /// Starts over with the values in the dictionary.
  void reload() noexcept;
  /// Forgets received values that wait for a SYNC (NMT state change).
  void forget() noexcept;
  /// A data frame of the PDO at @p position; one shorter than the mapping is ignored and counted.
  void on_frame(std::size_t position, const Frame& frame) noexcept;
  /// A SYNC: received values of synchronous RPDOs take effect.
  void on_sync() noexcept;
  /// Timer @p which of this service fired, counted from its first.
  void on_timer(std::size_t which) noexcept;

  std::span<const PdoSettings> pdos() const noexcept { return parameters_.pdos(); }
  /// Frames that were too short for their mapping.
  std::uint64_t too_short() const noexcept { return too_short_; }

  void on_pdo_changed(std::size_t position) noexcept override;
  void on_pdo_time_changed(std::size_t, std::uint8_t, std::int64_t) noexcept override {}

 private:
  struct Latch {
    std::uint64_t payload = 0;
    bool waits = false;
  };
  void apply(const PdoSettings& pdo, std::uint64_t payload) noexcept;

  Context& context_;
  PdoParameters parameters_;
  std::size_t first_timer_;
  std::vector<Latch> latches_;
  std::vector<std::uint16_t> waiting_;
  std::uint64_t too_short_ = 0;
};

}  // namespace canopen
