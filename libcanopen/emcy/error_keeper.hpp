#pragma once

#include <array>

#include "libcanopen/emcy/emcy_producer.hpp"

namespace canopen {

/// Keeps the error register 1001h and the error history 1003h and sends EMCY when an error comes or goes
/// (CiA 301, 7.2.7.1, 7.5.2.2, 7.5.2.4). Does nothing unless the policy says ErrorKeeping::Library.
class ErrorKeeper final : public Service, public EntryOwner {
 public:
  /// Errors that are kept at the same time. Further ones are sent and enter the history, but their bits do not
  /// stay in the error register and clear() does not know them.
  static constexpr std::size_t kMostErrors = 32;

  ErrorKeeper(Context& context, EmcyProducer& producer);

  /// Error @p code with @p detail has come: its bits of the error register are set, bit 0 always, EMCY is sent
  /// with @p detail in the first two manufacturer bytes, and the history has a new entry. Nothing happens while
  /// the same error with the same detail is already there. True if the dictionary has changed.
  bool raise(std::uint16_t code, std::uint16_t detail, std::uint8_t error_register) noexcept;
  /// That error is gone: EMCY "error reset" with what is left of the error register. Nothing happens if it is not
  /// there. True if the dictionary has changed.
  bool clear(std::uint16_t code, std::uint16_t detail) noexcept;
  /// Afresh: no error is present, and no EMCY tells of those that end. The history is what the dictionary holds,
  /// so that a reset empties it and the return of the bus does not. Else 1001h shows the errors that are present.
  void reload(Reload how) noexcept override;

  /// An entry of the history; NoData beyond their number.
  Result<std::int64_t> read(const Entry& entry, std::int64_t stored) override;
  /// 0 empties the history; InvalidValue for anything else.
  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  struct Present {
    std::uint16_t code, detail;
    std::uint8_t error_register;
  };

  Present* find(std::uint16_t code, std::uint16_t detail) noexcept;
  std::uint8_t show_register(std::uint8_t further_bits) noexcept;
  void log(std::uint32_t field) noexcept;
  void set_history(std::uint8_t sub_index, std::int64_t value) noexcept;
  std::int64_t history(std::uint8_t sub_index) const noexcept;

  EmcyProducer& producer_;
  bool enabled_;
  std::uint8_t room_ = 0;  ///< entries of the history
  std::array<Present, kMostErrors> present_{};
  std::size_t count_ = 0;
};

}  // namespace canopen
