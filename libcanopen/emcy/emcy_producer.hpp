#pragma once

#include <array>

#include "libcanopen/service/service.hpp"

namespace canopen {

/// Sends emergency messages (CiA 301, 7.2.7) under the COB-ID of 1014h, which bit 31 silences, no closer than the
/// inhibit time of 1015h (100 us). Sixteen messages wait for it, in the order in which they came; if there are
/// more, the one that has waited longest is dropped.
class EmcyProducer final : public Service, public EntryOwner {
 public:
  explicit EmcyProducer(Context& context);

  /// Sends error code @p code with the error register and the five manufacturer bytes. Nothing is sent in the NMT
  /// states that have no EMCY service.
  void send(std::uint16_t code, std::uint8_t error_register,
            const std::array<std::uint8_t, 5>& manufacturer) noexcept;

  void list_identifiers(IdentifierList& list) const noexcept override;
  /// Afresh: nothing waits any longer. Else what waits is sent under the new identifier.
  void reload(Reload how) noexcept override;
  /// Drops what waits.
  void stop() noexcept override { forget(); }
  /// The inhibit time is over.
  void on_timer(std::size_t which) noexcept override;

  /// A new inhibit time holds at once, for what waits already too.
  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  using Message = std::array<std::uint8_t, 8>;

  void forget() noexcept;
  void take_over() noexcept;
  Result<void> write_cob_id(std::uint32_t cob_id) noexcept;
  void set_inhibit_time(Duration inhibit) noexcept;
  void enqueue(const Message& message) noexcept;
  void transmit(const Message& message) noexcept;
  TimePoint next_moment() const noexcept { return sent_ + inhibit_; }

  Identifier identifier_ = 0;  ///< in use, 0 while there is none
  Duration inhibit_{};
  TimePoint sent_ = TimePoint::min();  ///< the latest message
  std::array<Message, 16> waiting_{};  ///< a ring
  std::size_t first_ = 0;              ///< in the ring
  std::size_t count_ = 0;
};

}  // namespace canopen
