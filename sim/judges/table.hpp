#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "sim/unit/judge.hpp"

namespace sim {

/// A rule that holds in every world, whatever goes wrong there.
struct Invariant {
  std::string_view name;
  std::string_view text;
  std::unique_ptr<Judge> (*make)(std::string_view name, std::size_t units);
};

/// All of them.
std::span<const Invariant> invariants() noexcept;
/// A judge of each, for a world of @p units.
std::vector<std::unique_ptr<Judge>> make_judges(std::size_t units);

}  // namespace sim
