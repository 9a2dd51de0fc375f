#pragma once

#include <functional>
#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "farm/mirror/mirror.hpp"
#include "os/descriptor.hpp"
#include "service/service_events.hpp"
#include "tests/fakes/fake_messages.hpp"

namespace farm {

/// Serves @p events until @p is_done; throws std::runtime_error if that takes too long.
void wait_until(axisd::ServiceEvents& events, const std::function<bool()>& is_done);

/// A client at the other end of a stream.
class TestClient {
 public:
  TestClient(axisd::ServiceEvents& events, os::Descriptor socket) : events_{&events}, socket_{std::move(socket)} {}

  /// Sends @p text as it is.
  void send(std::string_view text) const;
  /// Sends a request with @p id.
  void ask(int id, std::string_view method, const nlohmann::json& params = nlohmann::json::object()) const;
  /// The next line that comes, without its newline.
  [[nodiscard]] std::string line();
  /// Whether the other end has closed the connection, which it does in time.
  [[nodiscard]] bool is_closed();

 private:
  bool read();

  axisd::ServiceEvents* events_;
  os::Descriptor socket_;
  std::string input_;
  bool is_over_ = false;
};

/// A mirror of farm "lab" without a server. Doors have told at once, or so it seems to the mirror.
struct MirrorTest : testing::Test {
  MirrorTest() { start({.quiet = std::chrono::milliseconds{0}}); }

  /// Begins anew with @p times.
  void start(const MirrorTimes& times) {
    mirror.reset();
    mirror = std::make_unique<Mirror>(events, messages, "lab", "nats://127.0.0.1:4222/lab", times);
  }
  /// The server is reached, and host "a" has units line1/5 and line1/6, host "b" line2/5.
  void open_farm();
  /// The door of @p host tells its @p units: BUS/NODE each.
  void tell(const std::string& host, const std::vector<std::string>& units);
  [[nodiscard]] TestClient connect(Order order = Order::AsAsked);
  /// What the units have been asked next.
  fakes::FakeMessages::Asked asked();
  /// What @p asked asked for, answered by @p result.
  static std::string answer_to(const fakes::FakeMessages::Asked& asked, const nlohmann::json& result);

  axisd::ServiceEvents events;
  fakes::FakeMessages messages;
  std::unique_ptr<Mirror> mirror;
};

}  // namespace farm
