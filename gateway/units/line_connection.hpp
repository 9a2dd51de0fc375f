#pragma once

#include <memory>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "os/descriptor.hpp"
#include "service/service_events.hpp"

namespace gateway {

/// A connection to a control socket: lines in both directions, of which none is waited for.
class LineConnection {
 public:
  /// Most that waits to be taken by the daemon (bytes).
  static constexpr std::size_t kMostUnsent = 1024UL * 1024;

  /// Who hears.
  class Listener {
   public:
    virtual ~Listener() = default;
    /// @p line has come, without its newline. False: it is none of the protocol, and the connection ends.
    virtual bool on_line(std::string_view line) = 0;
    /// The connection has ended for the reason @p why; the last call, in which the connection may be destroyed.
    virtual void on_closed(const std::string& why) = 0;
  };

  /// Connects to the daemon at socket @p path, if it is one to be trusted; an error is one line. @p events and
  /// @p listener outlive it.
  [[nodiscard]] static tl::expected<std::unique_ptr<LineConnection>, std::string> open(
      axisd::ServiceEvents& events, const std::string& path, Listener& listener);
  LineConnection(const LineConnection&) = delete;
  LineConnection& operator=(const LineConnection&) = delete;
  ~LineConnection() = default;

  /// Sends @p line, with its newline. False if too much waits already; nothing of it is sent then.
  [[nodiscard]] bool send(std::string_view line);

 private:
  LineConnection(os::Descriptor socket, Listener& listener) : socket_{std::move(socket)}, listener_{listener} {}

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
