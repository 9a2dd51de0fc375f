#pragma once

#include <string>
#include <string_view>

#include "os/descriptor.hpp"
#include "service/service_events.hpp"

namespace gateway {

/// A connection to a daemon: lines in both directions, of which none is waited for.
class LineConnection {
 public:
  /// Most that waits to be taken by the daemon (bytes).
  static constexpr std::size_t kMostUnsent = 1024UL * 1024;

  /// Who hears.
  class Listener {
   public:
    virtual ~Listener() = default;
    /// @p line has come, without its newline. Why the connection ends with it; empty: it goes on.
    [[nodiscard]] virtual std::string on_line(std::string_view line) = 0;
    /// The connection has ended for the reason @p why; the last call, in which the connection may be destroyed.
    virtual void on_closed(const std::string& why) = 0;
  };

  /// Over @p socket, a stream that does not block. @p events and @p listener outlive it. Throws std::system_error.
  LineConnection(axisd::ServiceEvents& events, os::Descriptor socket, Listener& listener);
  LineConnection(const LineConnection&) = delete;
  LineConnection& operator=(const LineConnection&) = delete;
  ~LineConnection() = default;

  /// Sends @p line, with its newline. False if too much waits already; nothing of it is sent then.
  [[nodiscard]] bool send(std::string_view line);

 private:
  static int on_ready(sd_event_source* source, int descriptor, std::uint32_t events, void* self) noexcept;
  /// Why the connection has ended; empty while it has not.
  std::string serve(std::uint32_t events);
  std::string read();
  std::string flush();

  os::Descriptor socket_;
  Listener& listener_;
  std::string input_;
  std::string output_;
  axisd::EventSource source_;
};

}  // namespace gateway
