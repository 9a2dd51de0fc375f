#include "tools/canrec/frames/time_range.hpp"

#include "text/seconds.hpp"

namespace canrec {

namespace {

std::chrono::nanoseconds absolute(const Moment& moment, std::chrono::nanoseconds first) noexcept {
  return moment.is_absolute ? moment.time : first + moment.time;
}

}  // namespace

tl::expected<Moment, std::string> read_moment(std::string_view text) {
  const bool is_absolute = text.starts_with('@');
  const auto time = text::seconds(text.substr(is_absolute ? 1 : 0));
  if (!time)
    return tl::unexpected{
        std::string{"expected seconds behind the first frame, or @ and a time stamp of the log"}};
  return Moment{*time, is_absolute};
}

TimeRange::Place TimeRange::place_of(std::chrono::nanoseconds at, std::chrono::nanoseconds first) const noexcept {
  if (from && at < absolute(*from, first)) return Place::Before;
  return to && at >= absolute(*to, first) ? Place::Behind : Place::Within;
}

}  // namespace canrec
