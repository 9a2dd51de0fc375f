#pragma once

#include "libcanopen/base/export.hpp"
#include "libcanopen/node/context.hpp"

namespace canopen {

/// Sends the NMT state once a period (CiA 301, 7.2.8.3.2.2; object 1017h, in ms, 0 = off).
class CANOPEN_EXPORT HeartbeatProducer final : public EntryOwner {
 public:
  /// @p timer is the number of its timer in the context's queue. Works without object 1017h, silently.
  HeartbeatProducer(Context& context, std::size_t timer);

  /// Starts over with the value of 1017h; the boot-up frame of now counts as the first heartbeat.
  void reload() noexcept;
  /// Goes on with the value of 1017h: another one begins at once, as if it had been written.
  void take_over() noexcept;
  /// The period is over: sends and arms the next, one whole period after the last deadline.
  void on_timer() noexcept;
  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  Duration stored() const noexcept;
  void start(Duration period, Duration delay) noexcept;

  Context& context_;
  std::size_t timer_;
  Duration period_{};
  TimePoint due_{};
};

}  // namespace canopen
