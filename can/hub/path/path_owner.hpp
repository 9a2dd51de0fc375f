#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <sys/types.h>
#include <tl/expected.hpp>

#include "can/userbus/path.hpp"
#include "can/userbus/time.hpp"
#include "os/descriptor.hpp"

namespace hub {

/// Why a path cannot be served.
struct Refusal {
  userbus::StartStatus status;  ///< StartStatus::Served: another hub serves it
  std::string text;             ///< one line with the path
};

/// How a bus is wanted; what is not said may be as it is.
struct Wanted {
  std::optional<std::uint32_t> bit_rate;  ///< bit/s
  std::optional<userbus::TimeWish> time;
};

/// Owner of the path of a bus: of its socket, which listens, and of the lock beside it, which is what decides who
/// of several may replace a socket that a dead hub has left behind.
class PathOwner {
 public:
  /// Takes @p path. If another hub serves it, the outcome is StartStatus::Served, or StartStatus::Different if
  /// that is another than @p wanted. A hub that is starting or closing is waited for, some seconds
  /// at most.
  static tl::expected<PathOwner, Refusal> take(const userbus::Path& path, const Wanted& wanted);

  PathOwner(PathOwner&& other) noexcept;
  PathOwner(const PathOwner&) = delete;
  PathOwner& operator=(const PathOwner&) = delete;
  PathOwner& operator=(PathOwner&&) = delete;
  ~PathOwner();

  /// The socket that listens; it does not block.
  [[nodiscard]] int listener() const noexcept { return listener_.get(); }
  /// Writes @p process, the hub, into the lock file, for people to read.
  void sign(pid_t process) const noexcept;
  /// Gives the path up: whoever is waiting in the socket's backlog is told by the end of the connection, and
  /// starts the next hub.
  void release() noexcept;

 private:
  static tl::expected<PathOwner, Refusal> take_locked(const userbus::Path& path, const Wanted& wanted,
                                                      os::Descriptor lock);
  PathOwner(std::string path, os::Descriptor lock, os::Descriptor listener) noexcept;

  std::string path_;  // absolute: the hub may change its folder; empty = given up
  ino_t inode_;       // of the socket there
  os::Descriptor lock_;
  os::Descriptor listener_;
};

}  // namespace hub
