#pragma once

#include <array>

#include "libcanopen/base/export.hpp"
#include "libcanopen/emcy/emcy_producer.hpp"

namespace canopen {

/// Keeps the error register 1001h and the error history 1003h and sends EMCY when an error comes or goes
/// (CiA 301, 7.2.7.1, 7.5.2.2, 7.5.2.4). It leaves both objects alone unless the policy says
/// ErrorKeeping::Library.
class CANOPEN_EXPORT ErrorKeeper final : public EntryOwner {
 public:
  /// Errors that can be present at once; more are reported, but nothing tells their end.
  static constexpr std::size_t kMostPresent = 32;

  ErrorKeeper(Context& context, EmcyProducer& producer);

  /// Error @p code with @p detail has come: its bits of the error register and bit 0 are set, EMCY is sent with
  /// the detail in the first two manufacturer bytes, and the history has a new entry (detail << 16 | code).
  /// Nothing happens while the same error with the same detail is already there.
  void raise(std::uint16_t code, std::uint16_t detail, std::uint8_t error_register) noexcept;
  /// That error is gone: EMCY 0000h with what is left of the error register. Nothing happens if it is not there.
  void clear(std::uint16_t code, std::uint16_t detail) noexcept;
  /// The communication starts afresh: no error is present.
  void reload() noexcept;

  Result<std::int64_t> read(const Entry& entry, std::int64_t stored) override;
  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  struct Error {
    std::uint16_t code = 0;
    std::uint16_t detail = 0;
    std::uint8_t bits = 0;
  };
  bool keeps() const noexcept { return context_.policy.error_keeping == ErrorKeeping::Library; }
  Error* find(std::uint16_t code, std::uint16_t detail) noexcept;
  std::uint8_t show_register(std::uint8_t besides) noexcept;
  void log(std::uint32_t field) noexcept;

  Context& context_;
  EmcyProducer& producer_;
  const Entry* error_register_;  ///< 1001h, nullptr if there is none
  const Entry* history_;         ///< 1003h:00, nullptr if there is none
  std::uint8_t history_size_ = 0;
  std::array<Error, kMostPresent> present_{};
  std::size_t count_ = 0;
};

}  // namespace canopen
