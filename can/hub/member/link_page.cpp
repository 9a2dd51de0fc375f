#include "can/hub/member/link_page.hpp"

#include <new>

#include "can/userbus/protocol.hpp"

namespace hub {

void LinkPage::create() {
  memory_ = os::SharedMemory{"can-bus-link", userbus::kLinkPageSize};
  up_ = new (memory_.begin()) std::atomic<std::uint32_t>{0};
}

void LinkPage::set_up(bool up) noexcept {
  if (up_ != nullptr) up_->store(up ? 1 : 0, std::memory_order_release);
}

}  // namespace hub
