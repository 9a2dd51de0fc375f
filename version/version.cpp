#include "version/version.hpp"

#include <fmt/format.h>

#include "generated/version.hpp"

namespace version {

std::string_view number() noexcept {
  return kNumber;
}

std::string_view commit() noexcept {
  return kCommit;
}

std::string line(std::string_view program) {
  if (commit().empty()) return fmt::format("{} {}", program, number());
  return fmt::format("{} {} ({})", program, number(), commit());
}

}  // namespace version
