#pragma once

#include <optional>
#include <vector>

#include "libcanopen/service/service.hpp"

namespace canopen {

/// Watches the heartbeats of other nodes (CiA 301, 7.2.8.3.2.2; object 1016h, each entry node-ID << 16 | time in
/// ms; time 0, or a node-ID that is not 1..127: not used). Watching begins with the first heartbeat of the node
/// and begins anew after its boot-up message; a time-out is an error until the next heartbeat.
class HeartbeatConsumer final : public Service, public EntryOwner {
 public:
  explicit HeartbeatConsumer(Context& context);

  void list_identifiers(IdentifierList& list) const noexcept override;
  /// What could not be written is not used. Entries that have not changed watch on unless @p how is Afresh.
  void reload(Reload how) noexcept override;
  /// An error control frame of the node that entry @p position watches.
  void on_frame(const Frame& frame, std::size_t position) noexcept override;
  /// The time of entry @p position may be over.
  void on_timer(std::size_t position) noexcept override;

  /// InvalidValue for the node's own node-ID and for reserved bits; ParameterIncompatible for a node-ID that
  /// another entry watches, or whose error control identifier another service uses.
  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  enum class Life : std::uint8_t { Unknown, Present, Lost };
  /// What one entry has seen of its node.
  struct Watch {
    const Entry* entry = nullptr;
    Duration time{};
    TimePoint deadline{};
    std::optional<NmtState> state{};  ///< as last told
    Life life = Life::Unknown;
  };

  Result<void> check(std::size_t position, std::uint32_t word) const noexcept;
  bool is_current(std::size_t position) const noexcept;
  void take_over() noexcept;
  void release(std::size_t position) noexcept;
  void configure(std::size_t position, std::uint32_t word) noexcept;
  void on_boot_up(std::size_t position) noexcept;
  void on_heartbeat(std::size_t position, std::uint8_t code) noexcept;
  void stop_watching(std::size_t position) noexcept;
  std::uint8_t node_id(std::size_t position) const noexcept;

  std::vector<Watch> watches_;
  std::vector<Identifier> identifiers_;  ///< that each entry listens to, 0 if it is not used
};

}  // namespace canopen
