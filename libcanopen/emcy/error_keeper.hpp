#pragma once

#include "libcanopen/base/export.hpp"
#include "libcanopen/emcy/emcy_producer.hpp"

namespace canopen {

/// Keeps the error register 1001h and the error history 1003h and sends EMCY when an error comes or goes
/// (CiA 301, 7.2.7.1, 7.5.2.2, 7.5.2.4). Works only if the policy says ErrorKeeping::Library.
class CANOPEN_EXPORT ErrorKeeper final : public EntryOwner {
 public:
  ErrorKeeper(Context& context, EmcyProducer& producer);

  /// Error @p code with @p detail has come: its bits of the error register are set, EMCY is sent and the history
  /// has a new entry. Nothing happens while the same error with the same detail is already there.
  void raise(std::uint16_t code, std::uint16_t detail, std::uint8_t error_register) noexcept;
  /// That error is gone: EMCY "error reset" with what is left of the error register. Nothing happens if it is not
  /// there.
  void clear(std::uint16_t code, std::uint16_t detail) noexcept;
  /// Reset: no error is present, the history is empty.
  void reload() noexcept;

  Result<std::int64_t> read(const Entry& entry, std::int64_t stored) override;
  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  Context& context_;
  EmcyProducer& producer_;
};

}  // namespace canopen
