#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "can/nats/nats_handles.hpp"

namespace nats {

/// Where a NATS server is, and as whom it is spoken to.
struct Server {
  std::string url;           ///< "nats://HOST:PORT" or "tls://HOST:PORT"
  std::string credentials;   ///< file with user JWT and key, or a line NAME:PASSWORD; empty = none
  std::string certificates;  ///< file with the certificates that are trusted, empty = the system's
  std::string certificate;   ///< file with the own certificate, empty = none
  std::string key;           ///< file with its key

  [[nodiscard]] bool has_tls() const { return url.starts_with("tls://"); }
};

/// Whether what is sent to @p server, whose URL leads to @p host, can be read on the way: that is another host,
/// and TLS is not asked for.
[[nodiscard]] bool is_open_to_others(const Server& server, std::string_view host);

/// Options for a connection to @p server that never reconnects by itself, so that nothing is sent late; @p
/// patience is the time to connect in. The error is one line.
[[nodiscard]] tl::expected<Options, std::string> options_for(const Server& server, const std::string& client,
                                                             std::chrono::milliseconds patience);

/// Connects with @p options; the error is one line.
[[nodiscard]] tl::expected<Connection, std::string> connect(const Options& options);

/// Before anything of libnats is used: has libcrypto, from which that takes random numbers, ready. False: there is
/// no memory for it, and libnats would crash in it.
[[nodiscard]] bool open_library() noexcept;

/// What the library says to @p status and what it said last in this thread.
[[nodiscard]] std::string text_of(natsStatus status);

}  // namespace nats
