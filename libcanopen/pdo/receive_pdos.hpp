#pragma once

#include "libcanopen/base/export.hpp"
#include "libcanopen/pdo/parameters.hpp"

namespace canopen {

/// Takes received process data to the dictionary (CiA 301, 7.2.2): event-driven RPDOs at once, synchronous ones
/// with the next SYNC.
class CANOPEN_EXPORT ReceivePdos final : public PdoParameters::Listener {
 public:
  /// The owner of the values.
  class Receiver {
   public:
    virtual ~Receiver() = default;
    /// The values of RPDO @p number (0 for 1400h) have just been stored.
    virtual void on_rpdo(std::uint16_t number) noexcept = 0;
  };
  ReceivePdos(Context& context, const Policy& policy, IdentifierUse& identifiers, Receiver& receiver);

  /// Starts over with the values in the dictionary.
  void reload() noexcept;
  /// Forgets received values that wait for a SYNC (NMT state change).
  void forget() noexcept;
  /// A data frame of the PDO at @p position; one shorter than the mapping is ignored and counted.
  void on_frame(std::size_t position, const Frame& frame) noexcept;
  /// A SYNC: received values of synchronous RPDOs take effect.
  void on_sync() noexcept;

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
  Receiver& receiver_;
  PdoParameters parameters_;
  std::vector<Latch> latches_;
  std::vector<std::uint16_t> waiting_;
  std::uint64_t too_short_ = 0;
};

}  // namespace canopen
