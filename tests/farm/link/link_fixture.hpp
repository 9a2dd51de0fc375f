#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/types.h>

#include "farm/link/link.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace farm {

/// A nats-server with JetStream on the loopback interface of a network of the test's own.
class ServerProcess {
 public:
  ServerProcess();
  ServerProcess(const ServerProcess&) = delete;
  ServerProcess& operator=(const ServerProcess&) = delete;
  ~ServerProcess();

  [[nodiscard]] nats::Server address() const;
  void start();
  void kill();
  /// Has it stand still until go_on().
  void stop() const;
  void go_on() const;

 private:
  fakes::TemporaryDirectory folder_;
  pid_t process_ = -1;
};

/// Remembers how its link is.
struct Ear final : Link::Listener {
  void on_up() override { ++ups; }
  void on_down(const std::string& why) override { reasons.push_back(why); }

  int ups = 0;
  std::vector<std::string> reasons;
};

/// Links in the loop of the test.
class LinkTest : public testing::Test {
 protected:
  /// Lets things happen until @p is_done; a test that waits in vain fails.
  void wait_until(const std::function<bool()>& is_done);
  /// Lets things happen for @p time.
  void wait_for(std::chrono::milliseconds time);
  void wait_until_up(const Link& link) {
    wait_until([&link] { return link.is_up(); });
  }
  /// What @p job of @p link comes to.
  template <class Result>
  tl::expected<Result, std::string> run(Link& link,
                                        std::function<tl::expected<Result, std::string>(Storage&)> job) {
    std::optional<tl::expected<Result, std::string>> told;
    link.run<Result>(std::move(job), [&told](auto result) { told.emplace(std::move(result)); });
    wait_until([&told] { return told.has_value(); });
    return *std::move(told);
  }

  ServerProcess server_;
  axisd::ServiceEvents events_{[] {}};
};

}  // namespace farm
