#include "can/hub/notices.hpp"

#include <exception>

namespace hub {

void Notices::tell(std::string_view what, canopen::TimePoint now) noexcept {
  try {
    tell_left_out(now);
    if (limit_.judge(now) != bus::MessageLimit::Verdict::LeaveOut) notice_(name_ + ": " + std::string{what});
  } catch (const std::exception&) {  // no memory for a line: the frames are more important
  }
}

void Notices::on_time(canopen::TimePoint now) noexcept {
  try {
    tell_left_out(now);
  } catch (const std::exception&) {  // as above
  }
}

void Notices::tell_left_out(canopen::TimePoint now) {
  if (const std::uint64_t count = limit_.take_left_out(now); count != 0)
    notice_(name_ + ": ... " + std::to_string(count) + " more messages left out");
}

}  // namespace hub
