#pragma once

#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace device {

/// Judges the COB-IDs of the SDO servers besides the default one, 1201h for the control unit and one for each
/// axis: requests come under 601h to 67Fh, answers go under 581h to 5FFh, and bit 31 switches a server off.
class SdoIdentifiers final : public canopen::EntryOwner {
 public:
  /// Owns the writing of the COB-IDs in @p dictionary.
  explicit SdoIdentifiers(canopen::Dictionary& dictionary) {
    for (std::uint16_t index = kFirst; dictionary.contains(index); ++index)
      for (const std::uint8_t sub_index : {kRequest, kResponse}) dictionary.own_write(index, sub_index, *this);
  }

  /// InvalidValue for any other identifier.
  canopen::Result<void> write(const canopen::Entry& entry, std::int64_t value) override {
    const std::int64_t lowest = entry.sub_index == kRequest ? kFirstRequest : kFirstResponse;
    const bool is_off = (static_cast<std::uint32_t>(value) & canopen::cob_id::kInvalid) != 0;
    if (is_off || (value >= lowest && value <= lowest + kMostNodes - 1)) return {};
    return canopen::refuse(canopen::AbortCode::InvalidValue);
  }

 private:
  static constexpr std::uint16_t kFirst = 0x1201;
  static constexpr std::uint8_t kRequest = 1, kResponse = 2;
  static constexpr std::int64_t kFirstRequest = canopen::function_code::kSdoRequest + 1;
  static constexpr std::int64_t kFirstResponse = canopen::function_code::kSdoResponse + 1;
  static constexpr std::int64_t kMostNodes = 127;
};

}  // namespace device
