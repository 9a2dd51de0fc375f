#pragma once

#include <atomic>
#include <cstdint>

#include "os/shared_memory.hpp"

namespace hub {

/// A page of memory that members look at before they send: whether the wire is whole (userbus::LinkPage).
class LinkPage {
 public:
  /// Makes it; the wire is cut at first. std::system_error.
  void create();
  /// What members see from now on; nothing if it was not made.
  void set_up(bool up) noexcept;
  /// To be passed to members, which can only read it; negative if it was not made.
  [[nodiscard]] int descriptor() const noexcept { return memory_.descriptor(); }

 private:
  os::SharedMemory memory_;
  std::atomic<std::uint32_t>* up_ = nullptr;
};

}  // namespace hub
