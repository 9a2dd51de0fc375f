#include "os/fresh_pages.hpp"

#include <cerrno>
#include <system_error>

#include <sys/mman.h>

namespace os {

FreshPages::FreshPages(std::size_t size) {
  void* const pages =
      ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (pages == MAP_FAILED) throw std::system_error{errno, std::generic_category(), "mmap"};
  bytes_ = {static_cast<std::byte*>(pages), size};
}

FreshPages::~FreshPages() {
  ::munmap(bytes_.data(), bytes_.size());
}

void FreshPages::give_back() noexcept {
  ::madvise(bytes_.data(), bytes_.size(), MADV_DONTNEED);
}

}  // namespace os
