#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <sys/types.h>

#include "can/userbus/protocol.hpp"
#include "os/descriptor.hpp"

namespace bench {

/// What members of a bus ask for.
struct Wishes {
  std::size_t members = 2;
  bool one_hears = false;         ///< all but one filter everything out
  std::uint32_t most_frames = 1;  ///< that a message to a member may have
};

/// A process that hands messages on, and the sockets of all whom it serves: the first one sends, the others hear.
class FanOut {
 public:
  /// Members of the bus at @p path, whose hub is process @p hub. std::exception.
  static FanOut of_hub(const std::string& path, pid_t hub, const Wishes& wishes);
  /// The floor: a process of its own that reads a message of the first one and writes it to all others. With
  /// @p waits it asks first, as who hears several has to, whether there is something to read.
  static FanOut plain(std::size_t members, bool waits);

  FanOut(FanOut&& other) noexcept;
  FanOut(const FanOut&) = delete;
  FanOut& operator=(const FanOut&) = delete;
  FanOut& operator=(FanOut&&) = delete;
  /// Ends the process of plain().
  ~FanOut();

  /// Sends @p frames, in one message if that is taken (@p in_one) or each in its own, and returns when everybody
  /// who hears has them all.
  void pass(std::size_t frames, bool in_one) const;
  /// Processor time of the process so far (ns).
  [[nodiscard]] std::int64_t processor_time() const;

 private:
  FanOut(pid_t process, bool is_own) noexcept : process_{process}, is_own_{is_own} {}

  pid_t process_;
  bool is_own_;
  std::uint32_t most_frames_ = 1;  ///< that are taken in one message
  std::vector<os::Descriptor> sockets_;
  std::size_t hearers_ = 0;  ///< behind the first one
};

/// A program that serves the bus at path(), from now on to its end.
class Hub {
 public:
  /// @p program is canhub. std::exception.
  explicit Hub(const std::string& program);
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;
  ~Hub();

  [[nodiscard]] std::string path() const { return folder_ + "/bus"; }
  [[nodiscard]] pid_t process() const noexcept { return process_; }

 private:
  std::string folder_;
  pid_t process_ = 0;
};

}  // namespace bench
