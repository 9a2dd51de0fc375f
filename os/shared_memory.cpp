#include "os/shared_memory.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace os {

SharedMemory::SharedMemory(const char* name, std::size_t size) : size_{size} {
  const auto failed = [] { throw std::system_error{errno, std::generic_category(), "shared memory"}; };
  file_ = Descriptor{memfd_create(name, MFD_CLOEXEC | MFD_ALLOW_SEALING)};
  if (!file_ || ftruncate(file_.get(), static_cast<off_t>(size)) != 0) failed();
  void* const page = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file_.get(), 0);
  if (page == MAP_FAILED) failed();
  begin_ = page;
  // what is mapped already stays writable, and nobody else can write any more
  if (fcntl(file_.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_FUTURE_WRITE) == 0) return;
  const int error = errno;
  munmap(begin_, size_);
  errno = error;
  failed();
}

SharedMemory::SharedMemory(SharedMemory&& other) noexcept
    : file_{std::move(other.file_)}, begin_{std::exchange(other.begin_, nullptr)}, size_{other.size_} {}

SharedMemory& SharedMemory::operator=(SharedMemory&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(begin_, other.begin_);
  std::swap(size_, other.size_);
  return *this;
}

SharedMemory::~SharedMemory() {
  if (begin_ != nullptr) munmap(begin_, size_);
}

}  // namespace os
