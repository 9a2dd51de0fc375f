#include "can/hub/path/path_owner.hpp"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "can/hub/loop/clock.hpp"
#include "can/hub/path/path_lock.hpp"
#include "can/userbus/join.hpp"
#include "can/userbus/request.hpp"

namespace hub {

using userbus::StartStatus;

namespace {

using namespace std::chrono_literals;

/// How long a hub that is starting or closing is waited for, and how often it is looked for meanwhile.
constexpr canopen::Duration kPatience = 5s;
constexpr auto kPause = 5ms;
constexpr mode_t kNotForOthers = 0177;

/// As --time has it.
std::string text_of(const userbus::TimeWish& time) {
  const char* const name = userbus::kTimeNames[static_cast<std::size_t>(time.mode)];
  return time.mode == userbus::TimeMode::Scaled ? fmt::format("{}={:g}", name, time.scale) : name;
}

Refusal in_use(const std::string& path, std::string_view what) {
  return {.status = StartStatus::InUse, .text = fmt::format("{}: {}", path, what)};
}

Refusal failed(const std::string& path, std::string_view what, int error) {
  return {.status = StartStatus::Failed, .text = fmt::format("{}: {}: {}", path, what, std::strerror(error))};
}

Refusal different(const std::string& path, std::string_view how) {
  return {.status = StartStatus::Different, .text = fmt::format("{}: is served by another canhub, {}", path, how)};
}

/// Whose time the bus of @p member has.
userbus::TimeWish time_of(int member) noexcept {
  const userbus::TimePage* const page = userbus::map_time(member);
  if (page == nullptr) return {userbus::TimeMode::Real, 1};
  const userbus::TimeWish time{page->mode, page->scale};
  userbus::unmap_time(page);
  return time;
}

/// What a hub at @p rate bit/s, of which @p member is one, is to one that was @p wanted.
Refusal already_served(const std::string& path, int member, std::uint32_t rate, const Wanted& wanted) {
  if (wanted.bit_rate.value_or(rate) != rate)
    return different(path, rate == 0 ? "without a bit rate" : fmt::format("at {} bit/s", rate));
  const userbus::TimeWish time = time_of(member);
  const userbus::TimeWish as_wanted = wanted.time.value_or(time);
  if (as_wanted.mode != time.mode || as_wanted.scale != time.scale)
    return different(path, fmt::format("with the time {}", text_of(time)));
  return {.status = StartStatus::Served, .text = fmt::format("{}: is served by another canhub", path)};
}

/// Asks who serves @p path.
std::optional<Refusal> find_server(const userbus::Path& path, const Wanted& wanted) {
  const userbus::Joined joined = userbus::join(path, nullptr, userbus::Kind::Port, SOCK_CLOEXEC);
  const os::Descriptor member{joined.descriptor};
  if (!member && joined.error == userbus::JoinError::NotServed) return std::nullopt;
  if (!member) return in_use(path.text, userbus::text_of(joined.error));
  const userbus::Answer hello = userbus::ask(member.get(), userbus::Operation::Hello);
  if (hello.error != 0) return std::nullopt;
  return already_served(path.text, member.get(), static_cast<std::uint32_t>(hello.value), wanted);
}

/// 0 if there is nothing.
ino_t inode_at(const std::string& path) noexcept {
  struct stat status {};
  return lstat(path.c_str(), &status) == 0 ? status.st_ino : 0;
}

/// True if nobody answers at the socket @p path, whose hub must be dead.
bool is_stale(const userbus::Path& path) noexcept {
  const os::Descriptor probe{socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)};
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, path.text, std::strlen(path.text) + 1);
  return connect(probe.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 &&
         errno == ECONNREFUSED;
}

/// Makes @p path free for a socket; the caller has the lock.
std::optional<Refusal> clear(const userbus::Path& path, const Wanted& wanted) {
  struct stat status {};
  if (lstat(path.text, &status) != 0)
    return errno == ENOENT ? std::nullopt : std::optional{failed(path.text, "cannot be looked at", errno)};
  if (!S_ISSOCK(status.st_mode)) return in_use(path.text, "exists and is not a socket");
  if (is_stale(path)) {
    if (unlink(path.text) == 0 || errno == ENOENT) return std::nullopt;
    return failed(path.text, "is left behind by a dead process and cannot be removed", errno);
  }
  // its lock file has been removed by somebody else, or it is no hub
  if (auto server = find_server(path, wanted)) return server;
  return in_use(path.text, "is the socket of a program that is no canhub");
}

tl::expected<os::Descriptor, Refusal> listen_at(const userbus::Path& path, const Wanted& wanted) {
  if (auto refusal = clear(path, wanted)) return tl::unexpected{std::move(*refusal)};
  os::Descriptor listener{socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)};
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, path.text, std::strlen(path.text) + 1);
  const mode_t before = umask(kNotForOthers);
  const int bound = bind(listener.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address);
  const int error = errno;
  umask(before);
  if (bound != 0) return tl::unexpected{failed(path.text, "cannot be made", error)};
  if (listen(listener.get(), SOMAXCONN) != 0)
    return tl::unexpected{failed(path.text, "cannot be listened on", errno)};
  return listener;
}

}  // namespace

tl::expected<PathOwner, Refusal> PathOwner::take(const userbus::Path& path, const Wanted& wanted) {
  if (!userbus::own_folder(path))
    return tl::unexpected{failed(path.text, "its folder is not this user's alone (mode 0700)", errno)};
  const canopen::TimePoint end = monotonic_now() + kPatience;
  for (;;) {
    if (os::Descriptor lock = try_lock(path.text)) return take_locked(path, wanted, std::move(lock));
    if (errno != EWOULDBLOCK) return tl::unexpected{failed(lock_path(path.text), "cannot be locked", errno)};
    if (auto server = find_server(path, wanted)) return tl::unexpected{std::move(*server)};
    if (monotonic_now() > end)
      return tl::unexpected{in_use(lock_path(path.text), "is locked by a process that does not serve the bus")};
    std::this_thread::sleep_for(kPause);
  }
}

tl::expected<PathOwner, Refusal> PathOwner::take_locked(const userbus::Path& path, const Wanted& wanted,
                                                        os::Descriptor lock) {
  auto listener = listen_at(path, wanted);
  if (!listener) {
    remove_lock(path.text, lock);
    return tl::unexpected{std::move(listener.error())};
  }
  std::error_code ignored;
  return PathOwner{std::filesystem::absolute(path.text, ignored), std::move(lock), std::move(*listener)};
}

PathOwner::PathOwner(std::string path, os::Descriptor lock, os::Descriptor listener) noexcept
    : path_{std::move(path)}, inode_{inode_at(path_)}, lock_{std::move(lock)}, listener_{std::move(listener)} {}

PathOwner::PathOwner(PathOwner&& other) noexcept
    : path_{std::exchange(other.path_, {})},
      inode_{other.inode_},
      lock_{std::move(other.lock_)},
      listener_{std::move(other.listener_)} {}

PathOwner::~PathOwner() {
  release();
}

void PathOwner::sign(pid_t process) const noexcept {
  const std::string text = std::to_string(process) + '\n';
  if (ftruncate(lock_.get(), 0) == 0) [[maybe_unused]]
    const ssize_t written = pwrite(lock_.get(), text.data(), text.size(), 0);
}

void PathOwner::release() noexcept {
  if (path_.empty()) return;
  if (inode_at(path_) == inode_) unlink(path_.c_str());  // not that of another hub, if somebody removed ours
  listener_ = os::Descriptor{};
  remove_lock(path_, lock_);
  lock_ = os::Descriptor{};
  path_.clear();
}

}  // namespace hub
