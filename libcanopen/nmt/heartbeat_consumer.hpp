#pragma once

#include <span>
#include <vector>

#include "libcanopen/base/export.hpp"
#include "libcanopen/node/context.hpp"

namespace canopen {

/// Watches the heartbeats of other nodes (CiA 301, 7.2.8.3.2.2; object 1016h, each entry node-ID << 16 | time in
/// ms). Watching begins with the first heartbeat of the node.
class CANOPEN_EXPORT HeartbeatConsumer final : public EntryOwner {
 public:
  /// Uses the timers @p first_timer .. first_timer + timers_for(dictionary) - 1.
  HeartbeatConsumer(Context& context, std::size_t first_timer);
  /// Timers that the entries of 1016h in @p dictionary need.
  static std::size_t timers_for(const Dictionary& dictionary) noexcept;

  /// Starts over with the values of 1016h.
  void reload() noexcept;
  /// An error control frame of the node that entry @p position watches.
  void on_frame(std::size_t position, const Frame& frame) noexcept;
  /// Timer @p which of this service fired, counted from its first.
  void on_timer(std::size_t which) noexcept;
  /// The identifier that each entry listens to, 0 if it is not used.
  std::span<const Identifier> identifiers() const noexcept { return identifiers_; }

  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  Context& context_;
  std::size_t first_timer_;
  std::vector<Identifier> identifiers_;
};

}  // namespace canopen
