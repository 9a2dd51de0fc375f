#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace control {

/// What `status` and `units` say of a unit of each profile; one that says nothing is of kProfileS120.
inline constexpr std::string_view kProfileS120 = "s120";
inline constexpr std::string_view kProfileCia402 = "cia402";

/// The file of share/axisd/eds for a unit of @p profile with @p axes, 1..8: `axisd.eds`,
/// `axisd-cia402-2-axes.eds`.
[[nodiscard]] std::string eds_file_name(std::string_view profile, std::size_t axes);

}  // namespace control
