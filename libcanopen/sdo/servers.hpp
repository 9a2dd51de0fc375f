#pragma once

#include <array>
#include <vector>

#include "libcanopen/sdo/domain_locks.hpp"
#include "libcanopen/sdo/server.hpp"
#include "libcanopen/service/service.hpp"

namespace canopen {

/// All SDO servers of a node, at most 128, with their parameters (CiA 301, 7.5.2.33; objects 1200h to 127Fh). The
/// server of 1200h is always there, without the object too.
class SdoServers final : public Service, public EntryOwner {
 public:
  explicit SdoServers(Context& context);

  void list_identifiers(IdentifierList& list) const noexcept override;
  /// A server that keeps its identifiers keeps its transfer unless @p how is Afresh. A server whose identifiers
  /// cannot be had, or are those of a server before it, does not exist: bit 31 of its COB-IDs is set in the
  /// dictionary.
  void reload(Reload how) noexcept override;
  /// Forgets half-finished transfers without a word.
  void stop() noexcept override;
  /// A data frame for a server: @p slot is its position, from kViewed on where the view of the context says what
  /// it shows.
  void on_frame(const Frame& frame, std::size_t slot) noexcept override;
  /// The time of the server at @p position is over.
  void on_timer(std::size_t position) noexcept override { servers_[position].on_timer(); }
  /// Gives the answer that was put off (see Node::answer_deferred()).
  void answer_deferred(const Result<void>& result) noexcept {
    for (SdoServer& server : servers_) server.answer_deferred(result);
  }

  /// What each server has answered, that of 1200h first.
  std::size_t count() const noexcept { return servers_.size(); }
  const SdoAnswerCounters& answers(std::size_t position) const noexcept { return servers_[position].answers(); }

  /// A COB-ID of a server. InvalidValue if no server may have it, DeviceState if another one is in force,
  /// ParameterIncompatible if a service uses it.
  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  static constexpr std::size_t kViewed = 128;  ///< above the position of every server

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

  sdo::DomainLocks locks_;
  std::vector<SdoServer> servers_;
  std::vector<std::uint16_t> indices_;        ///< of the object of each server
  std::array<std::uint8_t, 128> position_{};  ///< of the server of each object
};

}  // namespace canopen
