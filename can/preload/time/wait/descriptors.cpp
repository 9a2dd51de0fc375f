#include "can/preload/time/wait/descriptors.hpp"

#include <atomic>

#include "can/preload/descriptor.hpp"

namespace preload {

namespace {

/// CAN sockets at greater descriptors are asked about each time.
constexpr int kMostKnown = 1024;
std::atomic<bool> known_on_bus[kMostKnown];

}  // namespace

bool is_known_on_bus(int descriptor) noexcept {
  return descriptor >= 0 && descriptor < kMostKnown && known_on_bus[descriptor].load(std::memory_order_relaxed);
}

bool is_on_bus(int descriptor) noexcept {
  userbus::Name name{};
  if (is_known_on_bus(descriptor)) return true;
  if (!is_can(descriptor, name) || name.kind == userbus::Kind::Down) return false;
  if (descriptor < kMostKnown) known_on_bus[descriptor].store(true, std::memory_order_relaxed);
  return true;
}

void forget_descriptor(int descriptor) noexcept {
  if (descriptor >= 0 && descriptor < kMostKnown) known_on_bus[descriptor].store(false, std::memory_order_relaxed);
}

}  // namespace preload
