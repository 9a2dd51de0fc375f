#pragma once

#include <array>

#include "audit/base/topic.hpp"
#include "audit/network/network.hpp"

namespace audit {

/// When and how a master has parameters stored and restored.
class StorageTopic final : public Topic {
 public:
  explicit StorageTopic(bool judges_times) noexcept : judges_times_{judges_times} {}

  void on_transfer(const Transfer& transfer, const Scene& scene) override;

 private:
  void take_save(const Transfer& transfer, const Scene& scene);

  /// Stores that a master may need in a minute.
  static constexpr std::size_t kMostStores = 5;
  /// When the last ones were, the oldest first.
  using Stores = std::array<canopen::Duration, kMostStores>;
  bool judges_times_;
  std::array<Stores, Network::kNodes> stores_{};
  std::array<std::uint64_t, Network::kNodes> counts_{};
};

}  // namespace audit
