#pragma once

#include "libcanopen/service/service.hpp"

namespace canopen {

/// Sends the NMT state once a period (CiA 301, 7.2.8.3.2.2; object 1017h, in ms, 0 = off).
class HeartbeatProducer final : public Service, public EntryOwner {
 public:
  /// Works without object 1017h, silently.
  explicit HeartbeatProducer(Context& context);

  void list_identifiers(IdentifierList& list) const noexcept override;
  /// Afresh: the boot-up frame of now counts as the first heartbeat. Else another value begins at once, as if it
  /// had been written.
  void reload(Reload how) noexcept override;
  /// The period is over: sends and arms the next, one whole period after the last deadline.
  void on_timer(std::size_t which) noexcept override;
  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  Duration stored() const noexcept;
  void begin(Duration period, Duration delay) noexcept;

  Duration period_{};
  TimePoint due_{};
};

}  // namespace canopen
