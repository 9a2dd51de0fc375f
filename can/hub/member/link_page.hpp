#pragma once

#include <atomic>
#include <cstdint>

#include "os/descriptor.hpp"

namespace hub {

/// A page of memory that members look at before they send: whether the wire is whole (userbus::LinkPage).
class LinkPage {
 public:
  LinkPage() = default;
  LinkPage(const LinkPage&) = delete;
  LinkPage& operator=(const LinkPage&) = delete;
  ~LinkPage();

  /// Makes it; the wire is cut at first. std::system_error.
  void create();
  /// What members see from now on; nothing if it was not made.
  void set_up(bool up) noexcept;
  /// To be passed to members, which can only read it; negative if it was not made.
  [[nodiscard]] int descriptor() const noexcept { return file_.get(); }

 private:
  os::Descriptor file_;
  std::atomic<std::uint32_t>* up_ = nullptr;
};

}  // namespace hub
