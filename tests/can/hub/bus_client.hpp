#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <linux/can.h>

#include "can/userbus/join.hpp"
#include "can/userbus/request.hpp"
#include "os/descriptor.hpp"

namespace hub_test {

/// A member of a bus, as the tests see it: what goes wrong in joining or asking is an exception.
class BusClient {
 public:
  /// Joins the bus at @p path, which must be served, and is bound to @p interface; not bound if that is empty, to
  /// all for "any".
  explicit BusClient(const std::string& path, std::string_view interface = "vcan0",
                     userbus::Kind kind = userbus::Kind::Raw);

  [[nodiscard]] int descriptor() const noexcept { return socket_.get(); }
  /// Index of @p interface.
  [[nodiscard]] int index_of(std::string_view interface) const;
  void bind(std::string_view interface);
  void set(userbus::OptionName option, std::uint32_t value = 1);
  void set_filters(std::span<const can_filter> filters);

  /// Sends the frame @p text (candump's notation) on the interface it is bound to.
  void send(std::string_view text) const;
  void send(const can_frame& frame) const;
  /// Sends @p bytes as they are; false if the socket is full.
  bool send_bytes(std::span<const std::byte> bytes) const;
  /// Sends @p bytes with @p count descriptors of the standard error, at most 8; they are lost if the socket is
  /// full.
  void send_with_descriptors(std::span<const std::byte> bytes, std::size_t count) const;
  /// Returns when the hub has read everything that was sent before.
  void settle() const;

  /// What has come so far.
  std::vector<userbus::FrameMessage> take();
  /// The same in candump's notation.
  std::vector<std::string> take_frames();
  /// Waits for one frame and gives it in candump's notation; empty if none comes, or the hub has gone.
  std::string wait_frame();
  /// True if the hub closes the connection; waits for it.
  [[nodiscard]] bool is_closed_by_hub() const;
  /// Ends the membership.
  void leave() { socket_ = os::Descriptor{}; }

  /// Asks; the errno is part of the answer.
  [[nodiscard]] userbus::Answer ask(userbus::Operation operation, int value = 0,
                                    std::span<const std::byte> payload = {}) const;
  /// The payload of the last answer.
  [[nodiscard]] const std::vector<std::byte>& reply() const noexcept { return reply_; }

 private:
  std::optional<userbus::FrameMessage> receive(bool wait) const;

  os::Descriptor socket_;
  mutable std::vector<std::byte> reply_;
};

/// The path @p text as the bus's interfaces want it.
userbus::Path path_of(const std::string& text);

}  // namespace hub_test
