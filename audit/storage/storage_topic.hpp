#pragma once

#include <array>
#include <map>
#include <utility>

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
  /// Stores of one set.
  struct Stores {
    std::array<canopen::Duration, kMostStores> times{};  ///< of the last ones, the oldest first
    std::uint64_t count = 0;
  };
  bool judges_times_;
  std::map<std::pair<std::uint8_t, std::uint8_t>, Stores> stores_;  ///< by node and sub-index of 1010h
};

}  // namespace audit
