#include "profidrive/interface/exchange.hpp"

#include <chrono>

#include "profidrive/telegram/parameter_numbers.hpp"

namespace profidrive {
namespace {

using namespace parameter;

constexpr unsigned kSignOfLifeShift = 12;
constexpr std::uint16_t kSignOfLifeBits = 0xF000;
constexpr std::uint16_t kSynchronised = 1U << 8;

std::size_t count_of(const drive::DriveObject& object, std::uint16_t number) noexcept {
  const drive::PlacedRow* const placed = drive::find_parameter(object.kind(), number);
  return placed != nullptr ? placed->row->count : 0;
}

/// @p word with the bits of @p mask as @p from has them.
std::uint16_t with_bits(std::uint16_t word, std::uint16_t from, std::uint16_t mask) noexcept {
  return static_cast<std::uint16_t>((word & ~unsigned{mask}) | (from & unsigned{mask}));
}

}  // namespace

Exchange::Exchange(drive::DriveObject& object) noexcept
    : object_{&object},
      received_words_{count_of(object, kReceivedWord)},
      sent_words_{count_of(object, kSentWord)} {}

void Exchange::select(const Selection& selection) noexcept {
  selection_ = selection;
  const bool has_telegram = selection.telegram != nullptr;
  sign_of_life_sent_ =
      has_telegram ? profidrive::place_of(selection.telegram->sent, &SentWord::has_sign_of_life) : std::nullopt;
  synchronised_sent_ =
      has_telegram ? profidrive::place_of(selection.telegram->sent, &SentWord::shows_synchronised) : std::nullopt;
}

void Exchange::receive(std::span<const std::uint16_t> words, std::size_t first) noexcept {
  if (first >= received_words_) return;
  const std::size_t count = std::min(words.size(), received_words_ - first);
  std::copy_n(words.begin(), count, pending_.begin() + static_cast<std::ptrdiff_t>(first));
  has_new_ = true;
}

/// Only axes know control by PLC.
bool Exchange::is_frozen() const noexcept {
  return object_->kind() != drive::ObjectKind::ControlUnit && without_control_ != WithoutControl::TakeAll &&
         (pending_[0] & kControlByPlc) == 0;
}

/// The word of the same drive object that p2045 = @p source is connected to, if it is one.
std::optional<std::size_t> Exchange::place_of(double source) const noexcept {
  const drive::BicoSource from = drive::unpack(static_cast<std::uint32_t>(source));
  const bool is_own = from.object == drive::kOwnObject || from.object == object_->number();
  const bool is_word = is_own && from.number == kReceivedWord && from.position < received_words_;
  return is_word ? std::optional<std::size_t>{from.position} : std::nullopt;
}

void Exchange::follow(std::uint16_t number, double value) noexcept {
  switch (number) {
    case kWithoutControl:
      without_control_ = WithoutControl{static_cast<std::uint8_t>(value)};
      break;
    case kFaultDelay:
      fault_delay_ = std::chrono::duration_cast<unit::Duration>(std::chrono::duration<double>{value});
      break;
    case kSignOfLife:
      sign_of_life_received_ = place_of(value);
      break;
    case kTolerance:
      tolerance_ = static_cast<std::uint16_t>(value);
      break;
    default:
      break;
  }
}

void Exchange::follow_parameters() noexcept {
  for (const std::uint16_t number : {kWithoutControl, kFaultDelay, kSignOfLife, kTolerance})
    follow(number, object_->kept_value(number).value_or(0.0));
}

std::optional<unsigned> Exchange::received_sign_of_life() const noexcept {
  if (is_frozen() && without_control_ == WithoutControl::FreezeWithSignOfLife) return std::nullopt;
  if (!sign_of_life_received_) return std::nullopt;
  return unsigned{pending_[*sign_of_life_received_]} >> kSignOfLifeShift;
}

void Exchange::take() noexcept {
  if (!has_new_) return;
  has_new_ = false;
  auto& received = object_->if1().received;
  if (!is_frozen()) {
    std::ranges::copy(std::span{pending_}.first(received_words_), received.begin());
    return;
  }
  received[0] = with_bits(received[0], pending_[0], kControlByPlc);
  if (without_control_ == WithoutControl::FreezeWithSignOfLife) return;
  if (const auto place = sign_of_life_received_)
    received[*place] = with_bits(received[*place], pending_[*place], kSignOfLifeBits);
}

void Exchange::sample(bool synchronised) noexcept {
  sign_of_life.advance();
  auto& out = object_->if1().sent;
  if (sign_of_life_sent_)
    out[*sign_of_life_sent_] =
        with_bits(out[*sign_of_life_sent_], static_cast<std::uint16_t>(sign_of_life.sent() << kSignOfLifeShift),
                  kSignOfLifeBits);
  if (synchronised_sent_)
    out[*synchronised_sent_] =
        with_bits(out[*synchronised_sent_], synchronised ? kSynchronised : std::uint16_t{0}, kSynchronised);
  sent_ = out;
}

}  // namespace profidrive
