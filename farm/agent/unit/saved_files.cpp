#include "farm/agent/unit/saved_files.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <sys/epoll.h>
#include <sys/inotify.h>
#include <unistd.h>

namespace farm::agent {

SavedFiles::SavedFiles(axisd::ServiceEvents& events, const Folders& folders, OnSaved on_saved)
    : folders_{folders}, on_saved_{std::move(on_saved)}, watches_{::inotify_init1(IN_CLOEXEC | IN_NONBLOCK)} {
  if (!watches_) throw std::system_error{errno, std::generic_category(), "cannot watch folders"};
  source_ = events.watch(
      watches_.get(), EPOLLIN,
      [](sd_event_source*, int, std::uint32_t, void* self) noexcept {
        static_cast<SavedFiles*>(self)->take();
        return 0;
      },
      this);
}

tl::expected<void, std::string> SavedFiles::watch(const UnitName& unit) {
  const std::string folder = folders_.saved(unit);
  const int watch = ::inotify_add_watch(watches_.get(), folder.c_str(), IN_MOVED_TO | IN_ONLYDIR);
  if (watch < 0) return tl::unexpected{fmt::format("{}: cannot be watched: {}", folder, std::strerror(errno))};
  units_[watch] = unit;
  return {};
}

void SavedFiles::leave(const UnitName& unit) {
  const auto known = std::ranges::find(units_, unit, &std::pair<const int, UnitName>::second);
  if (known == units_.end()) return;
  ::inotify_rm_watch(watches_.get(), known->first);
  units_.erase(known);
}

void SavedFiles::take() {
  alignas(inotify_event) std::array<char, 4096> buffer{};
  const ssize_t size = ::read(watches_.get(), buffer.data(), buffer.size());
  for (ssize_t at = 0; at < size;) {
    const auto* const event = reinterpret_cast<const inotify_event*>(&buffer[static_cast<std::size_t>(at)]);
    if (event->len > 0) tell_of(event->wd, static_cast<const char*>(event->name));
    at += static_cast<ssize_t>(sizeof *event + event->len);
  }
}

void SavedFiles::tell_of(int watch, std::string_view file) {
  const auto known = units_.find(watch);
  if (known == units_.end()) return;
  const UnitName unit = known->second;
  if (file == "parameters.bin") on_saved_(unit);
}

}  // namespace farm::agent
