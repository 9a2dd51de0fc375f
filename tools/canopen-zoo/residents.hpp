#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {

inline constexpr std::string_view kRight = "Right";  ///< name of the slave that does everything right

/// Every slave that can be run: those that are right, which no check finds, then those that are wrong.
[[nodiscard]] std::vector<WrongSlave> residents();

/// The one of that name; capital letters and hyphens in it do not count. Else in one line what was meant.
[[nodiscard]] tl::expected<WrongSlave, std::string> find_resident(std::string_view name);

/// The EDS that a tester of @p slave is given.
[[nodiscard]] std::string eds_of(const WrongSlave& slave);

}  // namespace zoo
