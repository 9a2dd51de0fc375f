#pragma once

#include <algorithm>
#include <vector>

#include <libcanopen/application/application.hpp>
#include <libcanopen/od/dictionary.hpp>

/// Every RPDO advances the counter 2000h by the step 2002h that it carries.
struct Counter final : canopen::Application {
  canopen::Cell<std::uint32_t> count;
  canopen::Cell<std::uint16_t> step;
  explicit Counter(canopen::Dictionary& objects)
      : count{objects.cell<std::uint32_t>(0x2000, 0)}, step{objects.cell<std::uint16_t>(0x2002, 0)} {}
  void on_rpdo(std::uint16_t) noexcept override { count.set(count.get() + step.get()); }
};

/// The DOMAIN 2001h: up to 1 MB that a master writes and reads back, in segments or in blocks. What comes in
/// counts only when it is complete.
struct Document final : canopen::DomainOwner {
  static constexpr std::size_t kLargest = 1'000'000;
  std::vector<std::uint8_t> content, incoming;
  Document() { content.reserve(kLargest), incoming.reserve(kLargest); }  // nothing is allocated while it runs

  canopen::Result<std::optional<std::uint32_t>> begin_read(const canopen::Entry&) noexcept override {
    return static_cast<std::uint32_t>(content.size());
  }
  canopen::Result<std::size_t> read(const canopen::Entry&, std::uint64_t offset,
                                    std::span<std::uint8_t> into) noexcept override {
    const std::size_t bytes = std::min<std::size_t>(into.size(), content.size() - offset);
    std::copy_n(content.begin() + static_cast<std::ptrdiff_t>(offset), bytes, into.begin());
    return bytes;
  }
  canopen::Result<void> begin_write(const canopen::Entry&, std::optional<std::uint32_t>) noexcept override {
    incoming.clear();
    return {};
  }
  canopen::Result<void> write(const canopen::Entry&, std::uint64_t,
                              std::span<const std::uint8_t> bytes) noexcept override {
    if (incoming.size() + bytes.size() > kLargest) return canopen::refuse(canopen::AbortCode::OutOfMemory);
    incoming.insert(incoming.end(), bytes.begin(), bytes.end());
    return {};
  }
  canopen::Result<void> end_write(const canopen::Entry&, std::uint64_t) noexcept override {
    content.swap(incoming);
    return {};
  }
};
