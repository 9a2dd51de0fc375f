#include "can/hub/member/link_page.hpp"

#include <cerrno>
#include <new>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include "can/userbus/protocol.hpp"

namespace hub {

LinkPage::~LinkPage() {
  if (up_ != nullptr) munmap(up_, userbus::kLinkPageSize);
}

void LinkPage::create() {
  const auto failed = [] {
    throw std::system_error{errno, std::generic_category(), "memory for the link's state"};
  };
  file_ = os::Descriptor{memfd_create("can-bus-link", MFD_CLOEXEC | MFD_ALLOW_SEALING)};
  if (!file_ || ftruncate(file_.get(), userbus::kLinkPageSize) != 0) failed();
  void* const page = mmap(nullptr, userbus::kLinkPageSize, PROT_READ | PROT_WRITE, MAP_SHARED, file_.get(), 0);
  if (page == MAP_FAILED) failed();
  // what is mapped already stays writable, and nobody else can write any more
  if (fcntl(file_.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_FUTURE_WRITE) != 0) failed();
  up_ = new (page) std::atomic<std::uint32_t>{0};
}

void LinkPage::set_up(bool up) noexcept {
  if (up_ != nullptr) up_->store(up ? 1 : 0, std::memory_order_release);
}

}  // namespace hub
