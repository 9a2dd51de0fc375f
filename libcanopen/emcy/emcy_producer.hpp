#pragma once

#include <array>

#include "libcanopen/base/export.hpp"
#include "libcanopen/node/context.hpp"

namespace canopen {

/// Sends emergency messages (CiA 301, 7.2.7) under the COB-ID of 1014h, which bit 31 silences, no closer than the
/// inhibit time of 1015h (100 us). Messages that come faster wait in order, at most kMostWaiting; then the oldest
/// of them is given up.
class CANOPEN_EXPORT EmcyProducer final : public EntryOwner {
 public:
  static constexpr std::size_t kMostWaiting = 16;

  /// @p timer is the number of its timer in the context's queue.
  EmcyProducer(Context& context, std::size_t timer);

  /// Sends error code @p code with the error register and the five manufacturer bytes. Nothing is sent in the NMT
  /// states that have no EMCY service.
  void send(std::uint16_t code, std::uint8_t error_register,
            const std::array<std::uint8_t, 5>& manufacturer) noexcept;
  /// The inhibit time is over.
  void on_timer() noexcept;
  /// Starts over with the values of 1014h and 1015h; what waits is forgotten.
  void reload() noexcept;
  /// The identifier in use, 0 while there is none.
  Identifier identifier() const noexcept { return identifier_; }

  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  Result<void> write_cob_id(std::uint32_t cob_id) noexcept;
  void write_inhibit_time(std::int64_t value) noexcept;
  void transmit(const Frame& frame) noexcept;
  void keep(const Frame& frame) noexcept;

  Context& context_;
  std::size_t timer_;
  Identifier identifier_ = 0;
  Duration inhibit_{};
  TimePoint allowed_{};  ///< no message before
  std::array<Frame, kMostWaiting> waiting_{};
  std::size_t first_ = 0;  ///< of `count_` messages in the ring
  std::size_t count_ = 0;
};

}  // namespace canopen
