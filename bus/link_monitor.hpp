#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "bus/descriptor.hpp"
#include "bus/interface.hpp"

namespace bus {

/// What is known of the watched interface: its state and its kernel index (0: none).
struct Link {
  LinkState state = LinkState::Gone;
  int index = 0;

  friend constexpr bool operator==(const Link&, const Link&) = default;
};

/// Follows @p link through the netlink messages of @p bytes; true if it was changed on the way.
bool follow_link_messages(std::span<const std::byte> bytes, std::string_view name, Link& link) noexcept;

/// Tells when one network interface goes up, goes down, disappears or appears (rtnetlink, group RTMGRP_LINK).
class LinkMonitor {
 public:
  /// Watches the interface called @p interface, which need not exist; throws std::system_error without rtnetlink.
  explicit LinkMonitor(std::string interface);

  /// File descriptor that polls readable when read() has something to say.
  [[nodiscard]] int descriptor() const noexcept { return socket_.get(); }
  /// Reads all that waits: the state it ends in, if any message changed the state on the way. The end may equal
  /// the start (gone and back again), in which case sockets on the interface need binding all the same.
  [[nodiscard]] std::optional<LinkState> read() noexcept;
  /// State as last told by read(), at first that of the construction.
  [[nodiscard]] LinkState state() const noexcept { return link_.state; }

 private:
  LinkState start_again() noexcept;

  std::string interface_;
  Descriptor socket_;
  Link link_;
};

}  // namespace bus
