#include "libcanopen/emcy/error_keeper.hpp"

#include <algorithm>

#include "libcanopen/base/object_index.hpp"

namespace canopen {
namespace {

constexpr std::uint8_t kMostEntries = 254;
constexpr std::uint16_t kErrorReset = 0x0000;
constexpr std::uint8_t kGenericError = 0x01;

}  // namespace

ErrorKeeper::ErrorKeeper(Context& context, EmcyProducer& producer)
    : Service{context, {.lives_in = kStatesOfObjects, .stage = ReloadStage::Senders}},
      producer_{producer},
      enabled_{context.policy.error_keeping == ErrorKeeping::Library} {
  if (!enabled_) return;
  Dictionary& dictionary = context_.dictionary;
  dictionary.serve_writes(object::kErrorField, 0, *this);
  for (std::uint8_t sub = 1; sub <= kMostEntries && dictionary.lookup(object::kErrorField, sub) != nullptr;
       ++sub) {
    dictionary.own_read(object::kErrorField, sub, *this, OwnerRank::Service);
    room_ = sub;
  }
}

ErrorKeeper::Present* ErrorKeeper::find(std::uint16_t code, std::uint16_t detail) noexcept {
  const auto end = present_.begin() + count_;
  const auto found = std::find_if(
      present_.begin(), end, [=](const Present& error) { return error.code == code && error.detail == detail; });
  return found != end ? &*found : nullptr;
}

bool ErrorKeeper::raise(std::uint16_t code, std::uint16_t detail, std::uint8_t error_register) noexcept {
  if (!enabled_ || find(code, detail) != nullptr) return false;
  const auto bits = static_cast<std::uint8_t>(error_register | kGenericError);
  if (count_ < kMostErrors) present_[count_++] = {code, detail, bits};
  log(std::uint32_t{detail} << 16 | code);
  producer_.send(code, show_register(bits),
                 {static_cast<std::uint8_t>(detail), static_cast<std::uint8_t>(detail >> 8), 0, 0, 0});
  return true;
}

bool ErrorKeeper::clear(std::uint16_t code, std::uint16_t detail) noexcept {
  Present* const error = find(code, detail);
  if (error == nullptr) return false;
  *error = present_[--count_];
  producer_.send(kErrorReset, show_register(0), {});
  return true;
}

void ErrorKeeper::reload(Reload how) noexcept {
  if (!enabled_) return;
  if (how == Reload::Afresh) count_ = 0;
  show_register(0);
}

/// Brings 1001h up to date. Returns it, with @p further_bits of an error that is not kept.
std::uint8_t ErrorKeeper::show_register(std::uint8_t further_bits) noexcept {
  std::uint8_t bits = 0;
  for (std::size_t i = 0; i < count_; ++i) bits |= present_[i].error_register;
  if (const Entry* const entry = context_.dictionary.lookup(object::kErrorRegister, 0))
    context_.dictionary.set(*entry, bits);
  return bits | further_bits;
}

/// The newest entry is the first: the others move down, the last one falls out.
void ErrorKeeper::log(std::uint32_t field) noexcept {
  if (room_ == 0) return;
  const auto count = static_cast<std::uint8_t>(std::min<std::int64_t>(history(0) + 1, room_));
  for (std::uint8_t sub = count; sub > 1; --sub) set_history(sub, history(static_cast<std::uint8_t>(sub - 1)));
  set_history(1, field);
  set_history(0, count);
}

void ErrorKeeper::set_history(std::uint8_t sub_index, std::int64_t value) noexcept {
  if (const Entry* const entry = context_.dictionary.lookup(object::kErrorField, sub_index)) {
    context_.dictionary.set(*entry, value);
  }
}

std::int64_t ErrorKeeper::history(std::uint8_t sub_index) const noexcept {
  return context_.dictionary.stored(object::kErrorField, sub_index).value_or(0);
}

Result<std::int64_t> ErrorKeeper::read(const Entry& entry, std::int64_t stored) {
  if (entry.sub_index > history(0)) return refuse(AbortCode::NoData);
  return stored;
}

Result<void> ErrorKeeper::write(const Entry&, std::int64_t value) {
  if (value != 0) return refuse(AbortCode::InvalidValue);
  return {};
}

}  // namespace canopen
