#pragma once

#include <array>

#include "libcanopen/base/export.hpp"
#include "libcanopen/node/context.hpp"

namespace canopen {

/// Sends emergency messages (CiA 301, 7.2.7) under the COB-ID of 1014h, which bit 31 silences, no closer than the
/// inhibit time of 1015h (100 us). Sixteen messages wait for it, in the order in which they came; if there are
/// more, the one that has waited longest is dropped.
class CANOPEN_EXPORT EmcyProducer final : public EntryOwner {
 public:
  /// @p timer is the number of its timer in the context's queue.
  EmcyProducer(Context& context, std::size_t timer);

  /// Sends error code @p code with the error register and the five manufacturer bytes. Nothing is sent in the NMT
  /// states that have no EMCY service.
  void send(std::uint16_t code, std::uint8_t error_register,
            const std::array<std::uint8_t, 5>& manufacturer) noexcept;
  /// The inhibit time is over.
  void on_timer() noexcept;
  /// Drops what waits: the NMT state has no EMCY service, or the identifier is gone.
  void forget() noexcept;
  /// Starts over with the values of 1014h and 1015h.
  void reload() noexcept;
  /// Goes on with the values of 1014h and 1015h: what waits is sent under the new identifier.
  void take_over() noexcept;
  /// The identifier in use, 0 while there is none.
  Identifier identifier() const noexcept { return identifier_; }

  /// A new inhibit time holds at once, for what waits already too.
  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  using Message = std::array<std::uint8_t, 8>;

  Result<void> write_cob_id(std::uint32_t cob_id) noexcept;
  void set_inhibit_time(Duration inhibit) noexcept;
  void enqueue(const Message& message) noexcept;
  void transmit(const Message& message) noexcept;
  TimePoint next_moment() const noexcept { return sent_ + inhibit_; }

  Context& context_;
  std::size_t timer_;
  Identifier identifier_ = 0;
  Duration inhibit_{};
  TimePoint sent_ = TimePoint::min();  ///< the latest message
  std::array<Message, 16> waiting_{};  ///< a ring
  std::size_t first_ = 0;              ///< in the ring
  std::size_t count_ = 0;
};

}  // namespace canopen
