#pragma once

#include <span>
#include <vector>

#include "libcanopen/base/export.hpp"
#include "libcanopen/sdo/server.hpp"

namespace canopen {

/// All SDO servers of a node, at most 128, with their parameters (CiA 301, 7.5.2.33; objects 1200h to 127Fh). The
/// server of 1200h is always there, without the object too.
class CANOPEN_EXPORT SdoServers final : public EntryOwner {
 public:
  /// Uses the timers @p first_timer .. first_timer + timers_for(dictionary) - 1.
  SdoServers(Context& context, std::size_t first_timer);
  /// Timers that the servers of @p dictionary need.
  static std::size_t timers_for(const Dictionary& dictionary) noexcept;

  /// Starts over with the values of the objects, without transfers.
  void reload() noexcept;
  /// Forgets half-finished transfers without a word (NMT state change).
  void forget() noexcept;
  /// A data frame for the server at @p position.
  void on_frame(std::size_t position, const Frame& frame) noexcept { servers_[position].on_frame(frame); }
  /// Timer @p which of this service fired, counted from its first.
  void on_timer(std::size_t which) noexcept { servers_[which].on_timer(); }
  std::span<const SdoServer> servers() const noexcept { return servers_; }

  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  Context& context_;
  std::vector<SdoServer> servers_;
};

}  // namespace canopen
