// How a process comes into the time of its bus.
#include <string>
#include <string_view>
#include <utility>

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "can/clock/time_share.hpp"
#include "can/port/user_bus/user_bus.hpp"

namespace bus {

namespace {

/// The part that who has started this process has made for it, if it is of the bus at @p path.
os::Descriptor inherited(const userbus::Path& path, std::uint32_t flags) noexcept {
  os::Descriptor clock{userbus::inherited_clock()};
  if (!clock) return {};
  sockaddr_un peer{};
  socklen_t length = sizeof peer;
  if (::getpeername(clock.get(), reinterpret_cast<sockaddr*>(&peer), &length) != 0) return {};
  if (std::string_view{peer.sun_path} != path.text) return {};
  ::fcntl(clock.get(), F_SETFD, FD_CLOEXEC);
  const userbus::TimeMessage join{.word = userbus::TimeMessage::Word::Join, .flags = flags, .process = ::getpid()};
  return userbus::tell_time(clock.get(), join) ? std::move(clock) : os::Descriptor{};
}

/// Whether with-can has the calls of this program go by the time of a bus already: its library says so.
bool is_wrapped() noexcept {
  void* const keeps_time = ::dlsym(RTLD_DEFAULT, "can_bus_keeps_time");
  return keeps_time != nullptr && reinterpret_cast<int (*)()>(keeps_time)() != 0;
}

}  // namespace

std::unique_ptr<TimeShare> TimeShare::join(const Address& address, std::uint32_t flags) {
  const auto* const place = std::get_if<UserBusPath>(&address.place);
  if (place == nullptr) return nullptr;
  userbus::Path path{};
  if (!userbus::copy_path(place->path.c_str(), path)) return nullptr;  // who opens it says so
  if (is_wrapped()) return nullptr;
  const auto failure = [&](userbus::JoinError error) {
    return OpenError{fmt::format("unix:{}: {}", place->path, userbus::text_of(error))};
  };
  if (os::Descriptor clock = inherited(path, flags)) {
    const userbus::TimePage* const page = userbus::map_time(clock.get());
    if (page == nullptr) return nullptr;
    auto time = std::make_unique<TimeShare>(path, std::move(clock), *page);
    time->note_touched();  // execve(2) has closed what somebody may wait for
    return time;
  }
  // an older hub knows no clocks, but can be asked
  const std::string hub = hub_program();
  const userbus::Joined asking = userbus::join(path, hub.c_str(), userbus::Kind::Port, SOCK_CLOEXEC);
  const os::Descriptor member{asking.descriptor};
  if (!member) throw failure(asking.error);
  const userbus::TimePage* const page = userbus::map_time(member.get());
  if (page == nullptr) return nullptr;
  const userbus::JoinedClock joined = userbus::join_clock(path, hub.c_str(), flags, ::getpid(), false);
  if (joined.descriptor < 0) throw failure(joined.error);
  return std::make_unique<TimeShare>(path, os::Descriptor{joined.descriptor}, *page);
}

}  // namespace bus
