#include "libcanopen/sdo/upload_source.hpp"

#include <algorithm>
#include <cassert>

namespace canopen::sdo {

Result<void> UploadSource::open(const Dictionary& dictionary, const Entry& entry) noexcept {
  if (entry.domain != nullptr) return open_domain(entry);
  if (entry.size != 0) {
    const auto value = dictionary.read(entry);
    if (!value) return refuse(value.error());
    store(window_.data(), *value);
    hold(entry.size);
    return {};
  }
  const auto text = dictionary.read_text(entry);
  if (!text) return refuse(text.error());
  if (text->size() > window_.size()) return refuse(AbortCode::OutOfMemory);
  std::copy(text->begin(), text->end(), window_.begin());
  hold(text->size());
  return {};
}

Result<void> UploadSource::open(SdoView& view, ViewedObject object) noexcept {
  const auto size = object.read(view, window_.first<kLongestViewedValue>());
  if (!size) return refuse(size.error());
  if (*size == 0 || *size > kLongestViewedValue) return refuse(AbortCode::CannotTransfer);
  hold(*size);
  return {};
}

void UploadSource::hold(std::size_t bytes) noexcept {
  first_ = 0;
  last_ = bytes;
  ended_ = true;
  size_ = static_cast<std::uint32_t>(bytes);
}

Result<void> UploadSource::open_domain(const Entry& entry) noexcept {
  const auto size = entry.domain->begin_read(entry);
  if (!size) return refuse(size.error());
  entry_ = &entry;
  size_ = *size;
  asked_ = 0;
  first_ = last_ = 0;
  ended_ = size_ == 0U;
  return {};
}

Result<void> UploadSource::refill() noexcept {
  assert(entry_ != nullptr && entry_->domain != nullptr && first_ <= last_);
  std::copy(data(), data() + available(), window_.data());
  last_ = available();
  first_ = 0;
  std::span<std::uint8_t> room = window_.subspan(last_);
  if (size_) room = room.first(static_cast<std::size_t>(std::min<std::uint64_t>(room.size(), *size_ - asked_)));
  const auto given = entry_->domain->read(*entry_, asked_, room);
  if (!given) return refuse(given.error());
  if (*given > room.size() || (size_ && *given < room.size())) return refuse(AbortCode::CannotTransfer);
  last_ += *given;
  asked_ += *given;
  ended_ = size_ ? asked_ == *size_ : *given < room.size();
  return {};
}

}  // namespace canopen::sdo
