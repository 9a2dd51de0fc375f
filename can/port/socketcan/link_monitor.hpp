#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "can/port/link.hpp"
#include "os/descriptor.hpp"

namespace bus {

/// What is known of the watched interface: its state and its kernel index (0: none).
struct KnownLink {
  LinkState state = LinkState::Gone;
  int index = 0;

  friend constexpr bool operator==(const KnownLink&, const KnownLink&) = default;
};

/// Follows @p link through the netlink messages of @p bytes; true if it was changed on the way.
bool follow_link_messages(std::span<const std::byte> bytes, std::string_view name, KnownLink& link) noexcept;

/// Tells when one network interface goes up, goes down, disappears or appears (rtnetlink, group RTMGRP_LINK).
class LinkMonitor final : public Link {
 public:
  /// Watches the interface called @p interface, which need not exist; throws std::system_error without rtnetlink.
  explicit LinkMonitor(std::string interface);

  [[nodiscard]] int descriptor() const noexcept override { return socket_.get(); }
  [[nodiscard]] std::optional<LinkState> read() noexcept override;
  [[nodiscard]] LinkState state() const noexcept override { return link_.state; }

 private:
  LinkState start_again() noexcept;

  std::string interface_;
  os::Descriptor socket_;
  KnownLink link_;
};

}  // namespace bus
