#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace hub::trunk {

class Trunk;

/// What has become of the frames of @p trunk, and who else is on the bus: JSON, at most @p room bytes. @p lost:
/// frames that were sent while the wire was cut.
[[nodiscard]] std::string report_of(const Trunk& trunk, std::uint64_t lost, std::size_t room);

}  // namespace hub::trunk
