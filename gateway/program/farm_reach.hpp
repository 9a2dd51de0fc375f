#pragma once

#include <fcntl.h>

#include "farm/mirror/mirror_thread.hpp"
#include "gateway/units/reach.hpp"

namespace gateway {

/// A farm as the only daemon. Answers come as the units give them: one that is slow keeps nobody waiting.
class FarmReach final : public Reach {
 public:
  /// Begins to connect to the server of @p farm. Throws std::system_error.
  explicit FarmReach(const farm::FarmUrl& farm) : mirror_{farm, "axisd-http"} {}

  [[nodiscard]] std::vector<std::string> places() const override { return {mirror_.place()}; }
  [[nodiscard]] bool are_named() const noexcept override { return true; }
  [[nodiscard]] bool do_units_change() const noexcept override { return true; }
  [[nodiscard]] tl::expected<os::Descriptor, std::string> connect(const std::string&) override {
    auto socket = mirror_.connect(farm::Order::AsAnswered);
    if (socket) ::fcntl(socket->get(), F_SETFL, O_NONBLOCK);
    return socket;
  }

 private:
  farm::MirrorThread mirror_;
};

}  // namespace gateway
