#pragma once

#include <microhttpd.h>

#include "gateway/server/http_server.hpp"

namespace gateway {

/// A request on its way through the library.
struct HttpServer::Turn {
  Door* door;
  MHD_Connection* connection;
  Connection* from;
  std::shared_ptr<Exchange> exchange;
  bool is_whole = false;
  bool is_too_long = false;
  bool is_suspended = false;
  bool is_streaming = false;

  /// The connection is not looked at until resume().
  void suspend() noexcept {
    is_suspended = true;
    MHD_suspend_connection(connection);
  }
  void resume() noexcept {
    if (!is_suspended) return;
    is_suspended = false;
    MHD_resume_connection(connection);
    door->look_soon();
  }
};

/// What the library calls, each with the door as its first argument.
struct HttpServer::Callbacks {
  /// A connection has been opened, or closed.
  static void on_connection(void* door, MHD_Connection* connection, void** context,
                            MHD_ConnectionNotificationCode code) noexcept;
  /// The headers of a request have come, a part of its body, its end, or it is resumed.
  static MHD_Result on_access(void* door, MHD_Connection* connection, const char* path, const char* verb,
                              const char* version, const char* data, std::size_t* size, void** turn) noexcept;
  /// The answer has been sent, or the client has left.
  static void on_completed(void* door, MHD_Connection* connection, void** turn,
                           MHD_RequestTerminationCode code) noexcept;
  /// There is room for @p size bytes of a stream.
  static ssize_t on_room(void* turn, std::uint64_t position, char* to, std::size_t size) noexcept;
  /// A new request, answered already if its headers are enough for that.
  static Turn* begin(Door& door, MHD_Connection* connection, Request request);
  static void take_body(Turn& turn, std::string_view part);
  /// All of the request has come.
  static void finish(Turn& turn);
  static MHD_Result answer_if_there(Turn& turn);
  /// Texts of a URL stay as they were sent.
  static std::size_t keep_encoded(void* door, MHD_Connection* connection, char* text) noexcept;
};

}  // namespace gateway
