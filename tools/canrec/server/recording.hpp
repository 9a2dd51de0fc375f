#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace canrec {

/// What the name of the stream of a recording begins with.
inline constexpr std::string_view kStreamPrefix = "CANREC_";

/// A recording as the server has it.
struct Recording {
  enum class State : std::uint8_t {
    Running,
    Stuck,    ///< it runs, but the stream of its bus is another one than that which it has followed
    Stopped,  ///< nothing more comes in
  };

  std::string name;
  std::string bus;  ///< name of the bus, or of the interface in the log of which it was made
  bool is_of_log = false;
  State state = State::Running;
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;
  std::uint64_t first = 0;          ///< sequence of the first message
  std::uint64_t last = 0;           ///< and of the last one; there may be none
  std::chrono::nanoseconds from{};  ///< time stamp of the first message, since 1970
  std::chrono::nanoseconds to{};    ///< and of the last one

  /// Name of the stream of the recording @p name.
  [[nodiscard]] static std::string stream_of(const std::string& name) { return std::string{kStreamPrefix} + name; }
};

}  // namespace canrec
