#pragma once

#include <cstdint>
#include <vector>

#include "libcanopen/od/domain_owner.hpp"

namespace zoo {

/// A DOMAIN in memory: what was written last, whole.
class Document final : public canopen::DomainOwner {
 public:
  /// Holds @p bytes at first.
  explicit Document(std::vector<std::uint8_t> bytes) : bytes_{std::move(bytes)} {}

  canopen::Result<std::optional<std::uint32_t>> begin_read(const canopen::Entry& entry) noexcept override;
  canopen::Result<std::size_t> read(const canopen::Entry& entry, std::uint64_t offset,
                                    std::span<std::uint8_t> into) noexcept override;
  canopen::Result<void> begin_write(const canopen::Entry& entry,
                                    std::optional<std::uint32_t> size) noexcept override;
  canopen::Result<void> write(const canopen::Entry& entry, std::uint64_t offset,
                              std::span<const std::uint8_t> more) noexcept override;
  canopen::Result<void> end_write(const canopen::Entry& entry, std::uint64_t size) noexcept override;
  void cancel_write(const canopen::Entry&) noexcept override {}

 private:
  std::vector<std::uint8_t> bytes_;
  std::vector<std::uint8_t> coming_;
};

}  // namespace zoo
