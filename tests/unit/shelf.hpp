#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "unit/parameter_storage.hpp"

namespace unit {

/// Keeps the saved parameters in memory.
struct Shelf final : ParameterKeeper {
  Keeping on_store(std::span<const std::byte> stored) noexcept override {
    if (is_full) return Keeping::Failed;
    image.assign(stored.begin(), stored.end());
    ++stores;
    return is_slow ? Keeping::Begun : Keeping::Kept;
  }
  void on_restore() noexcept override { ++restores; }

  std::vector<std::byte> image;  ///< as last stored
  int stores = 0;
  int restores = 0;
  bool is_full = false;  ///< nothing more can be stored
  bool is_slow = false;  ///< the test tells when something is stored
};

}  // namespace unit
