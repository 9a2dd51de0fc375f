#include "drive/measurement/encoder_interface.hpp"

#include <limits>

namespace drive {
namespace {

// Bits of Gn_STW; those of Gn_ZSW that mirror them have the same places.
constexpr unsigned kFunctions = 0x000F;
constexpr unsigned kCommandShift = 4;
constexpr unsigned kCommand = 0x7;
constexpr unsigned kAbsoluteValue = 13;
constexpr unsigned kPark = 14;
constexpr unsigned kAcknowledge = 15;

// Bits of Gn_ZSW alone.
constexpr unsigned kValuesShift = 4;
constexpr unsigned kAcknowledges = 11;
constexpr unsigned kFault = 15;

constexpr unsigned kActivate = 1, kRead = 2, kCancel = 3;
constexpr std::uint32_t kEncoderFault = 1;  ///< error code in Gn_XIST2

}  // namespace

void EncoderInterface::run(const Seen& seen) noexcept {
  const std::uint16_t before = control_;
  control_ = static_cast<std::uint16_t>(static_cast<std::int64_t>(inputs.control_words[0]));
  const auto came = [=, this](unsigned bit) { return has(bit) && (unsigned{before} >> bit & 1U) == 0; };
  if (came(kAcknowledge)) acknowledged_ = seen.faulty && !seen.cause_present;
  if (!seen.faulty) acknowledged_ = false;
  taken_ = acknowledged_ ? std::numeric_limits<double>::quiet_NaN() : inputs.control_words[0];
  if (has(kPark))
    active_ = available_ = 0;
  else if (control_ != before)
    command(control_ >> kCommandShift & kCommand, control_ & kFunctions, seen.position);
}

void EncoderInterface::command(unsigned command, unsigned functions, std::uint32_t position) noexcept {
  if (command == kActivate) active_ |= functions;
  if (command == kCancel) active_ &= ~functions;
  if (command == kRead) read_ = position;
  available_ = command == kRead ? functions : 0;
}

bool EncoderInterface::shows_fault(bool faulty) const noexcept {
  return faulty && !acknowledged_ && !has(kPark);
}

std::uint16_t EncoderInterface::status(bool faulty) const noexcept {
  constexpr unsigned kMirrored = 1U << kAbsoluteValue | 1U << kPark;
  unsigned word = active_ | available_ << kValuesShift | (control_ & (has(kPark) ? 1U << kPark : kMirrored));
  if (has(kAcknowledge)) word |= 1U << kAcknowledges;
  if (shows_fault(faulty)) word |= 1U << kFault;
  return static_cast<std::uint16_t>(word);
}

std::uint32_t EncoderInterface::second_value(bool faulty, std::uint32_t absolute) const noexcept {
  if (control_ == 0) return absolute;
  if (has(kPark)) return 0;
  if (shows_fault(faulty)) return kEncoderFault;
  if (available_ != 0) return read_;
  return has(kAbsoluteValue) ? absolute : 0;
}

}  // namespace drive
