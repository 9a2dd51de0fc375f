#include "tools/canopen-zoo/slave/document.hpp"

#include <algorithm>

namespace zoo {
namespace {

/// What a transfer may bring: nobody fills the memory of the machine over a bus.
constexpr std::size_t kLargest = std::size_t{1} << 20U;

}  // namespace

canopen::Result<std::optional<std::uint32_t>> Document::begin_read(const canopen::Entry&) noexcept {
  return static_cast<std::uint32_t>(bytes_.size());
}

canopen::Result<std::size_t> Document::read(const canopen::Entry&, std::uint64_t offset,
                                            std::span<std::uint8_t> into) noexcept {
  const std::size_t from = std::min<std::uint64_t>(offset, bytes_.size());
  const std::size_t count = std::min(into.size(), bytes_.size() - from);
  std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(from), count, into.begin());
  return count;
}

canopen::Result<void> Document::begin_write(const canopen::Entry&, std::optional<std::uint32_t> size) noexcept {
  if (size.value_or(0) > kLargest) return canopen::refuse(canopen::AbortCode::OutOfMemory);
  coming_.clear();
  return {};
}

canopen::Result<void> Document::write(const canopen::Entry&, std::uint64_t offset,
                                      std::span<const std::uint8_t> more) noexcept {
  if (offset + more.size() > kLargest) return canopen::refuse(canopen::AbortCode::OutOfMemory);
  coming_.insert(coming_.end(), more.begin(), more.end());
  return {};
}

canopen::Result<void> Document::end_write(const canopen::Entry&, std::uint64_t) noexcept {
  bytes_ = coming_;
  return {};
}

}  // namespace zoo
