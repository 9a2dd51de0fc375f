#include "control/eds_file.hpp"

#include <fmt/format.h>

namespace control {

std::string eds_file_name(std::string_view profile, std::size_t axes) {
  const std::string_view device = profile == kProfileCia402 ? "axisd-cia402" : "axisd";
  return axes == 1 ? fmt::format("{}.eds", device) : fmt::format("{}-{}-axes.eds", device, axes);
}

}  // namespace control
