#include "daemon/fleet/instance_lock.hpp"

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace axisd {
namespace {

std::string in_use(const bus::Address& address, const std::string& station) {
  return fmt::format("{}: node {} is served by another axisd", address.text, station);
}

std::string lock_of(const bus::Address& address, const std::string& station) {
  return fmt::format("axisd/{}/{}", bus::label(address), station);
}

/// Throws for the present errno, which is @p taken if another instance holds the lock on @p what.
[[noreturn]] void fail_to_lock(const std::string& what, int taken, const std::string& busy) {
  throw InstanceError{errno == taken ? busy : fmt::format("{}: cannot be locked: {}", what, std::strerror(errno))};
}

/// Creates @p folder and what of its parents is missing, for this user alone whatever the umask is; 0 or the
/// error.
int create_folders(const std::filesystem::path& folder) {
  std::filesystem::path part;
  for (const std::filesystem::path& name : folder) {
    part /= name;
    if (mkdir(part.c_str(), S_IRWXU) == 0 || errno == EEXIST) continue;
    const int error = errno;
    std::error_code unknown;
    if (!std::filesystem::exists(part, unknown)) return error;
  }
  return 0;
}

os::Descriptor lock_folder(const std::filesystem::path& folder, const std::string& busy) {
  os::Descriptor descriptor{open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
  if (!descriptor)
    throw InstanceError{fmt::format("{}: cannot be opened: {}", folder.string(), std::strerror(errno))};
  if (flock(descriptor.get(), LOCK_EX | LOCK_NB) != 0) fail_to_lock(folder.string(), EWOULDBLOCK, busy);
  return descriptor;
}

/// Whether the socket at @p address is one of this user's or of root's: anybody may take a name of the abstract
/// name space, and shall not keep our unit from starting.
bool is_trusted(const sockaddr_un& address, socklen_t length) noexcept {
  const os::Descriptor probe{socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)};
  ucred peer{};
  socklen_t size = sizeof peer;
  return connect(probe.get(), reinterpret_cast<const sockaddr*>(&address), length) == 0 &&
         getsockopt(probe.get(), SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 &&
         (peer.uid == geteuid() || peer.uid == 0);
}

/// Nothing if somebody else has taken the name.
os::Descriptor lock_name(const std::string& name, const std::string& busy) {
  os::Descriptor descriptor{socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0)};
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  name.copy(&address.sun_path[1], sizeof address.sun_path - 1);  // a leading zero byte makes the name abstract
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  if (bind(descriptor.get(), reinterpret_cast<const sockaddr*>(&address), length) != 0) {
    const int error = errno;
    if (error == EADDRINUSE && !is_trusted(address, length)) return os::Descriptor{};
    errno = error;
    fail_to_lock(name, EADDRINUSE, busy);
  }
  if (listen(descriptor.get(), SOMAXCONN) != 0)
    fail_to_lock(name, EADDRINUSE, busy);  // so that others see whose it is
  return descriptor;
}

}  // namespace

std::filesystem::path state_root(const std::string& given) {
  const auto variable = [](const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr ? std::filesystem::path{value} : std::filesystem::path{};
  };
  if (!given.empty()) return given;
  // systemd separates several folders by colons; the first is ours.
  if (const auto from_systemd = variable("STATE_DIRECTORY").string(); !from_systemd.empty()) {
    return from_systemd.substr(0, from_systemd.find(':'));
  }
  if (const auto xdg = variable("XDG_STATE_HOME"); !xdg.empty()) return xdg / "axisd";
  if (const auto home = variable("HOME"); !home.empty()) return home / ".local" / "state" / "axisd";
  throw InstanceError{"no place for the state: give --state-directory or set HOME"};
}

InstanceLock::InstanceLock(std::filesystem::path directory, const bus::Address& address,
                           const std::string& station)
    : directory_{std::move(directory)} {
  if (const int error = create_folders(directory_))
    throw InstanceError{fmt::format("{}: cannot be created: {}", directory_.string(), std::strerror(error))};
  name_ = lock_name(lock_of(address, station), in_use(address, station));
  folder_ = lock_folder(directory_, fmt::format("{}: is in use by another axisd", directory_.string()));
}

void InstanceLock::serve(const bus::Address& address, int node_id) {
  const std::string station = std::to_string(node_id);
  served_name_ = lock_name(lock_of(address, station), in_use(address, station));
}

}  // namespace axisd
