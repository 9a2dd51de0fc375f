#pragma once

#include <optional>
#include <utility>

#include "can/port/link.hpp"

namespace fakes {

/// A way to a bus that is as the test says.
class FakeLink final : public bus::Link {
 public:
  bus::LinkState now = bus::LinkState::Up;
  std::optional<bus::LinkState> news{};  ///< what the next read() tells

  int descriptor() const noexcept override { return -1; }
  std::optional<bus::LinkState> read() noexcept override {
    if (news) now = *news;
    return std::exchange(news, std::nullopt);
  }
  bus::LinkState state() const noexcept override { return now; }
};

}  // namespace fakes
