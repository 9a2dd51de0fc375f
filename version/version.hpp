#pragma once

#include <string>
#include <string_view>

namespace version {

/// Version of axisd and of the programs beside it: "0.2.0".
[[nodiscard]] std::string_view number() noexcept;

/// The first ten digits of the commit that was built, with "-dirty" behind them if files had been changed since;
/// empty if the sources lay in no repository of their own.
[[nodiscard]] std::string_view commit() noexcept;

/// What `PROGRAM --version` prints: "axisd 0.2.0 (1a2b3c4d5e)", or "axisd 0.2.0" without a commit.
[[nodiscard]] std::string line(std::string_view program);

}  // namespace version
