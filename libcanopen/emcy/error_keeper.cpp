#include "libcanopen/emcy/error_keeper.hpp"

#include <algorithm>

namespace canopen {
namespace {

constexpr std::uint16_t kErrorRegister = 0x1001;
constexpr std::uint16_t kErrorHistory = 0x1003;
constexpr std::uint8_t kMostLogged = 254;
constexpr std::uint8_t kGenericError = 0x01;

}  // namespace

ErrorKeeper::ErrorKeeper(Context& context, EmcyProducer& producer)
    : context_{context},
      producer_{producer},
      error_register_{context.dictionary.lookup(kErrorRegister, 0)},
      history_{context.dictionary.lookup(kErrorHistory, 0)} {
  if (!keeps() || history_ == nullptr) return;
  if (history_->writable) context_.dictionary.own_write(kErrorHistory, 0, *this, OwnerRank::Service);
  while (history_size_ < kMostLogged &&
         context_.dictionary.lookup(kErrorHistory, static_cast<std::uint8_t>(history_size_ + 1)) != nullptr) {
    ++history_size_;
    context_.dictionary.own_read(kErrorHistory, history_size_, *this, OwnerRank::Service);
  }
}

ErrorKeeper::Error* ErrorKeeper::find(std::uint16_t code, std::uint16_t detail) noexcept {
  Error* const end = present_.data() + count_;
  Error* const found =
      std::find_if(present_.data(), end, [=](const Error& e) { return e.code == code && e.detail == detail; });
  return found != end ? found : nullptr;
}

/// Shows the bits of all present errors and @p besides in 1001h, and returns them.
std::uint8_t ErrorKeeper::show_register(std::uint8_t besides) noexcept {
  unsigned bits = besides;
  for (std::size_t i = 0; i < count_; ++i) bits |= present_[i].bits;
  if (bits != 0) bits |= kGenericError;
  if (error_register_ != nullptr) context_.dictionary.set(*error_register_, bits);
  return static_cast<std::uint8_t>(bits);
}

void ErrorKeeper::raise(std::uint16_t code, std::uint16_t detail, std::uint8_t error_register) noexcept {
  if (!keeps() || find(code, detail) != nullptr) return;
  if (count_ < kMostPresent) present_[count_++] = {code, detail, error_register};
  const std::uint8_t bits = show_register(error_register);
  log(std::uint32_t{detail} << 16 | code);
  producer_.send(code, bits, {static_cast<std::uint8_t>(detail), static_cast<std::uint8_t>(detail >> 8), 0, 0, 0});
}

void ErrorKeeper::clear(std::uint16_t code, std::uint16_t detail) noexcept {
  Error* const error = keeps() ? find(code, detail) : nullptr;
  if (error == nullptr) return;
  *error = present_[--count_];
  producer_.send(0, show_register(0), {});
}

void ErrorKeeper::reload() noexcept {
  count_ = 0;
  if (keeps()) show_register(0);
}

/// The newest entry comes first (CiA 301, 7.5.2.4).
void ErrorKeeper::log(std::uint32_t field) noexcept {
  if (history_size_ == 0) return;
  Dictionary& dictionary = context_.dictionary;
  const Entry* const first = history_ + 1;  // the entries of an object lie one after the other
  for (std::size_t i = history_size_; i > 1; --i) dictionary.set(first[i - 1], dictionary.stored(first[i - 2]));
  dictionary.set(*first, field);
  dictionary.set(*history_, std::min<std::int64_t>(dictionary.stored(*history_) + 1, history_size_));
}

Result<std::int64_t> ErrorKeeper::read(const Entry& entry, std::int64_t stored) {
  if (entry.sub_index > context_.dictionary.stored(*history_)) return refuse(AbortCode::NoData);
  return stored;
}

Result<void> ErrorKeeper::write(const Entry&, std::int64_t value) {
  return value == 0 ? Result<void>{} : refuse(AbortCode::InvalidValue);
}

}  // namespace canopen
