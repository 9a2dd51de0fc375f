#pragma once

#include <array>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include "tests/support/allocation_counter.h"

namespace support {

/// The counts of a program that runs with the allocation counter preloaded.
class AllocationCounts {
 public:
  /// Calls of each function of allocation_counter.h.
  using Calls = std::array<std::uint64_t, ALLOCATION_FORMS>;

  /// Makes the file @p path; @p library is the path of the built library. Throws std::runtime_error.
  AllocationCounts(std::string path, std::string library) : path_{std::move(path)}, library_{std::move(library)} {
    const int file = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (file < 0 || ftruncate(file, ALLOCATION_FILE_SIZE) != 0) throw std::runtime_error{path_};
    void* const mapped = mmap(nullptr, ALLOCATION_FILE_SIZE, PROT_READ, MAP_SHARED, file, 0);
    close(file);
    if (mapped == MAP_FAILED) throw std::runtime_error{path_};
    counts_ = static_cast<const std::uint64_t*>(mapped);
  }
  AllocationCounts(const AllocationCounts&) = delete;
  AllocationCounts& operator=(const AllocationCounts&) = delete;
  ~AllocationCounts() { munmap(const_cast<std::uint64_t*>(counts_), ALLOCATION_FILE_SIZE); }

  /// What the environment of the program must contain.
  std::array<std::string, 2> environment() const {
    return {"LD_PRELOAD=" + library_, "AXISD_ALLOCATION_COUNTS=" + path_};
  }
  /// Calls so far.
  Calls calls() const {
    Calls result{};
    for (std::size_t form = 0; form < result.size(); ++form) {
      result[form] = __atomic_load_n(&counts_[form], __ATOMIC_RELAXED);
    }
    return result;
  }
  /// Calls of any form so far.
  std::uint64_t sum() const {
    const Calls all = calls();
    return std::accumulate(all.begin(), all.end(), std::uint64_t{0});
  }

 private:
  std::string path_;
  std::string library_;
  const std::uint64_t* counts_ = nullptr;
};

}  // namespace support
