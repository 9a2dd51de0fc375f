#include "farm/agent/process/short_run.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace farm::agent {
namespace {

constexpr std::chrono::seconds kPatience{10};
/// Of the output (bytes).
constexpr std::size_t kMost = 4096;

/// What waits in @p pipe, which does not block.
std::string content_of(int pipe) {
  std::array<char, kMost> buffer{};
  const ssize_t size = ::read(pipe, buffer.data(), buffer.size());
  return {buffer.data(), size < 0 ? 0 : static_cast<std::size_t>(size)};
}

}  // namespace

ShortRun::ShortRun(axisd::ServiceEvents& events, const std::vector<std::string>& words, OnEnd on_end)
    : on_end_{std::move(on_end)} {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0)
    throw std::system_error{errno, std::generic_category(), "cannot create a pipe"};
  output_ = os::Descriptor{ends[0]};
  const os::Descriptor input{ends[1]};
  auto process = start_program({.words = words, .variables = {}, .output = input.get()});
  timer_ = events.timer(
      [](sd_event_source*, std::uint64_t, void* self) noexcept {
        auto& it = *static_cast<ShortRun*>(self);
        it.process_ ? it.process_->end() : it.finish({.is_good = false, .how = it.failure_});
        return 0;
      },
      this);
  if (process)
    process_ = std::make_unique<WatchedProcess>(events, *std::move(process),
                                                [this](const ProcessEnd& end) { finish(end); });
  else
    failure_ = process.error();
  axisd::ServiceEvents::start(timer_, process_ ? kPatience : std::chrono::seconds{0});
}

void ShortRun::finish(const ProcessEnd& end) {
  const OnEnd tell = std::move(on_end_);
  tell(end, content_of(output_.get()));
}

}  // namespace farm::agent
