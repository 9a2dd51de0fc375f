#pragma once

#include <array>
#include <span>
#include <vector>

#include "libcanopen/base/export.hpp"
#include "libcanopen/sdo/domain_locks.hpp"
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

  /// Goes on with the values of the objects; a server that keeps its identifiers keeps its transfer. A server
  /// whose identifiers cannot be had, or are those of a server before it, does not exist: bit 31 of its COB-IDs is
  /// set in the dictionary.
  void reload() noexcept;
  /// Forgets half-finished transfers without a word (NMT state change).
  void forget() noexcept;
  /// A data frame for the server at @p position.
  void on_frame(std::size_t position, const Frame& frame) noexcept { servers_[position].on_frame(frame); }
  /// The same where the view of the context says what the server shows.
  void on_viewed_frame(std::size_t position, const Frame& frame) noexcept {
    servers_[position].on_viewed_frame(frame);
  }
  /// Timer @p which of this service fired, counted from its first.
  void on_timer(std::size_t which) noexcept { servers_[which].on_timer(); }
  /// Gives the answer that was put off (see Node::answer_deferred()).
  void answer_deferred(const Result<void>& result) noexcept {
    for (SdoServer& server : servers_) server.answer_deferred(result);
  }
  /// In the order of their objects.
  std::span<const SdoServer> servers() const noexcept { return servers_; }

  /// A COB-ID of a server. InvalidValue if no server may have it, DeviceState if another one is in force,
  /// ParameterIncompatible if a service uses it.
  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  /// The COB-IDs of one server.
  struct CobIds {
    std::uint32_t request, response;
  };

  void own(std::uint16_t index);
  CobIds cob_ids(std::size_t position) const noexcept;
  std::uint32_t cob_id(std::uint16_t index, std::uint8_t sub_index, std::uint32_t otherwise) const noexcept;
  bool is_incomplete(std::size_t position, CobIds stored) const noexcept;
  void mark_invalid(std::size_t position) noexcept;
  bool is_possible(std::size_t position, CobIds wanted) const noexcept;
  bool is_default(std::size_t position, Identifier identifier) const noexcept;
  bool is_allowed(std::size_t position, std::uint8_t sub_index, std::uint32_t cob_id) const noexcept;
  bool is_kept(std::size_t position, Identifier identifier) const noexcept;
  bool may_have(std::size_t position, std::uint8_t sub_index, std::uint32_t cob_id) const noexcept;
  Result<void> check(std::size_t position, std::uint8_t sub_index, std::uint32_t cob_id) const noexcept;
  void connect(std::size_t position, CobIds wanted) noexcept;

  Context& context_;
  sdo::DomainLocks locks_;
  std::vector<SdoServer> servers_;
  std::vector<std::uint16_t> indices_;        ///< of the object of each server
  std::array<std::uint8_t, 128> position_{};  ///< of the server of each object
};

}  // namespace canopen
