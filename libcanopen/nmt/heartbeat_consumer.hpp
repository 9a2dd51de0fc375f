#pragma once

#include <optional>
#include <span>
#include <vector>

#include "libcanopen/base/export.hpp"
#include "libcanopen/node/context.hpp"

namespace canopen {

/// Watches the heartbeats of other nodes (CiA 301, 7.2.8.3.2.2; object 1016h, each entry node-ID << 16 | time in
/// ms, not used if one of them is 0). Watching begins with the first heartbeat of a node; its boot-up message is
/// none.
class CANOPEN_EXPORT HeartbeatConsumer final : public EntryOwner {
 public:
  /// Uses the timers @p first_timer .. first_timer + timers_for(dictionary) - 1.
  HeartbeatConsumer(Context& context, std::size_t first_timer);
  /// Timers that the entries of 1016h in @p dictionary need.
  static std::size_t timers_for(const Dictionary& dictionary) noexcept;

  /// Starts over with the values of 1016h; an entry that could not be written is not used.
  void reload() noexcept;
  /// An error control frame of the node that entry @p position watches; ignored if it is not one byte long.
  void on_frame(std::size_t position, const Frame& frame) noexcept;
  /// Timer @p which of this service fired, counted from its first.
  void on_timer(std::size_t which) noexcept;
  /// The identifier that each entry listens to, 0 if it is not used.
  std::span<const Identifier> identifiers() const noexcept { return identifiers_; }

  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  struct Watch {
    Duration time{};
    TimePoint deadline{};          ///< the timer is not moved with every heartbeat
    std::optional<NmtState> seen;  ///< what the node told last, if it is alive
    bool runs = false;
    bool lost = false;
  };
  Result<void> judge(std::size_t position, std::uint32_t value) const noexcept;
  void use(std::size_t position, std::uint32_t value) noexcept;
  std::uint8_t node_id(std::size_t position) const noexcept;

  Context& context_;
  std::size_t first_timer_;
  std::vector<Identifier> identifiers_;
  std::vector<Watch> watches_;
};

}  // namespace canopen
