#pragma once

#include <array>

#include "libcanopen/base/export.hpp"
#include "libcanopen/base/identifier_use.hpp"
#include "libcanopen/node/context.hpp"

namespace canopen {

/// Sends emergency messages (CiA 301, 7.2.7) under the COB-ID of 1014h; bit 31 of it silences them.
class CANOPEN_EXPORT EmcyProducer final : public EntryOwner {
 public:
  EmcyProducer(Context& context, const IdentifierUse& identifiers);

  /// Sends error code @p code with the error register and the five manufacturer bytes. Nothing is sent in the NMT
  /// states that have no EMCY service.
  void send(std::uint16_t code, std::uint8_t error_register,
            const std::array<std::uint8_t, 5>& manufacturer) noexcept;
  /// Starts over with the value of 1014h.
  void reload() noexcept;
  /// The identifier in use, 0 while there is none.
  std::uint32_t identifier() const noexcept { return identifier_; }

  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  Context& context_;
  const IdentifierUse& identifiers_;
  std::uint32_t identifier_ = 0;
};

}  // namespace canopen
