#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "daemon/watch/streams/frame_buffer.hpp"
#include "daemon/watch/streams/sample_buffer.hpp"

namespace axisd {

/// Lines of the control socket, each with its newline and no longer than one may be, that tell what waits in
/// @p buffer of @p unit and take it out: none if nothing waits. The first one tells what was lost since the call
/// before.
[[nodiscard]] std::vector<std::string> frame_lines(std::string_view unit, FrameBuffer& buffer);
/// The same of samples.
[[nodiscard]] std::vector<std::string> sample_lines(std::string_view unit, SampleBuffer& buffer);

}  // namespace axisd
