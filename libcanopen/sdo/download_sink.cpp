#include "libcanopen/sdo/download_sink.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace canopen::sdo {
namespace {

/// Bytes that a value of @p entry may have.
std::uint64_t capacity_of(const Entry& entry) noexcept {
  if (entry.domain != nullptr) return UINT64_MAX;
  return entry.size != 0 ? entry.size : entry.description->capacity;
}

/// The number in @p bytes, as many as @p entry has.
std::int64_t number_in(const Entry& entry, std::span<const std::uint8_t> bytes) noexcept {
  std::array<std::uint8_t, sizeof(std::uint64_t)> word{};
  std::copy(bytes.begin(), bytes.end(), word.begin());
  const auto bits = load<std::uint64_t>(word.data());
  return entry.is_signed ? sign_extend(bits, entry.size) : static_cast<std::int64_t>(bits);
}

Result<void> write_number(Context& context, const Entry& entry, std::span<const std::uint8_t> bytes) noexcept {
  if (bytes.size() != entry.size) return refuse(AbortCode::LengthMismatch);
  const std::int64_t value = number_in(entry, bytes);
  auto written = context.dictionary.write(entry, value);
  const bool by_owner = !written && Dictionary::check(entry, value);
  if (by_owner) context.application.on_write_refused(entry, value, written.error());
  return written;
}

}  // namespace

Result<void> write_value(Context& context, const Entry& entry, std::span<const std::uint8_t> bytes) noexcept {
  auto written =
      entry.size != 0 ? write_number(context, entry, bytes) : context.dictionary.write_text(entry, bytes);
  if (written) context.application.on_sdo_written(entry);
  return written;
}

Result<void> DownloadSink::open(const Entry& entry, std::optional<std::uint32_t> size) noexcept {
  assert(!is_open());
  const std::uint64_t capacity = capacity_of(entry);
  if (size && (*size > capacity || (entry.size != 0 && *size != entry.size))) {
    return refuse(AbortCode::LengthMismatch);
  }
  if (entry.domain != nullptr) {
    if (auto begun = entry.domain->begin_write(entry, size); !begun) return begun;
  }
  entry_ = &entry;
  expect(capacity, size);
  return {};
}

Result<void> DownloadSink::open(ViewedObject object, std::optional<std::uint32_t> size) noexcept {
  assert(!is_open());
  if (size && (*size == 0 || *size > kLongestViewedValue)) return refuse(AbortCode::LengthMismatch);
  object_ = object;
  expect(kLongestViewedValue, size);
  return {};
}

void DownloadSink::expect(std::uint64_t capacity, std::optional<std::uint32_t> size) noexcept {
  held_ = 0;
  given_ = 0;
  most_ = size ? *size : capacity;
  size_said_ = size.has_value();
}

Result<void> DownloadSink::append(std::span<const std::uint8_t> bytes) noexcept {
  assert(is_open() && given_ + held_ <= most_);
  if (bytes.size() > most_ - given_ - held_) {
    return refuse(size_said_ ? AbortCode::LengthTooHigh : AbortCode::LengthMismatch);
  }
  if (held_ + bytes.size() > window_.size()) {
    if (auto taken = flush(); !taken) return taken;
  }
  assert(held_ + bytes.size() <= window_.size());
  std::copy(bytes.begin(), bytes.end(), window_.data() + held_);
  held_ += bytes.size();
  return {};
}

Result<void> DownloadSink::flush() noexcept {
  assert(entry_->domain != nullptr);  // everything else fits into the window
  if (held_ == 0) return {};
  if (auto taken = entry_->domain->write(*entry_, given_, window_.first(held_)); !taken) return taken;
  if (entry_ == nullptr) return refuse(AbortCode::DeviceState);  // the owner has reset the node
  given_ += held_;
  held_ = 0;
  return {};
}

Result<void> DownloadSink::commit(Context& context) noexcept {
  assert(is_open());
  if (size_said_ && given_ + held_ < most_) return refuse(AbortCode::LengthTooLow);
  if (entry_ == nullptr) return commit_viewed(*context.view);
  const Entry& entry = *entry_;
  if (entry.domain != nullptr) {
    if (auto taken = flush(); !taken) return taken;
    entry_ = nullptr;  // the owner may reset the node, which cancels what is not complete
    auto counts = entry.domain->end_write(entry, given_);
    if (counts) {
      context.application.on_sdo_written(entry);
    } else {
      entry.domain->cancel_write(entry);
    }
    return counts;
  }
  entry_ = nullptr;  // the write may take the server away, and the transfer with it
  return write_value(context, entry, window_.first(held_));
}

Result<void> DownloadSink::commit_viewed(SdoView& view) noexcept {
  if (held_ == 0) return refuse(AbortCode::LengthMismatch);
  const ViewedObject object = *object_;
  object_.reset();  // the write may take the server away
  return object.write(view, window_.first(held_), true);
}

void DownloadSink::cancel() noexcept {
  object_.reset();
  const Entry* const entry = std::exchange(entry_, nullptr);
  if (entry != nullptr && entry->domain != nullptr) entry->domain->cancel_write(*entry);
}

}  // namespace canopen::sdo
