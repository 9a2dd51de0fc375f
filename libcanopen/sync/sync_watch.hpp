#pragma once

#include "libcanopen/service/service.hpp"
#include "libcanopen/sync/sync_listener.hpp"

namespace canopen {

/// Watches that SYNC comes in Operational: from the first one on, within one and a half of the communication cycle
/// period (1006h, in us, 0 = off). A missing one is an error until the next SYNC, in whatever NMT state that
/// comes.
class SyncWatch final : public Service, public SyncListener, public EntryOwner {
 public:
  /// Works without object 1006h, silently.
  explicit SyncWatch(Context& context);

  /// Afresh: nothing is missing.
  void reload(Reload how) noexcept override;
  /// Waits for a first SYNC again.
  void stop() noexcept override;
  void on_sync(std::uint8_t counter, Duration window) noexcept override;
  /// The time may be over.
  void on_timer(std::size_t which) noexcept override;
  /// Another period counts at once, from now on.
  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  void set_period(std::int64_t cycle) noexcept;
  void end_timeout() noexcept;

  Duration patience_{};   ///< 0: nobody watches
  TimePoint deadline_{};  ///< the armed timer may fire earlier: it is not moved by every SYNC
  bool timed_out_ = false;
};

}  // namespace canopen
