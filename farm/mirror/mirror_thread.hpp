#pragma once

#include <functional>
#include <future>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "farm/documents/agent_beat.hpp"
#include "farm/link/link.hpp"
#include "farm/mirror/connections.hpp"
#include "farm/naming/farm_url.hpp"
#include "os/descriptor.hpp"

namespace farm {

/// A mirror of a farm in a thread of its own, for a program that speaks to control sockets. It begins to connect
/// to the server when it is made. All functions may be called by any other thread.
class MirrorThread {
 public:
  /// Of the farm at @p farm; the server sees the connection under the name @p program. Throws std::system_error.
  MirrorThread(const FarmUrl& farm, const std::string& program);
  MirrorThread(const MirrorThread&) = delete;
  MirrorThread& operator=(const MirrorThread&) = delete;
  /// Ends all connections.
  ~MirrorThread();

  /// "lab".
  [[nodiscard]] const std::string& farm() const noexcept { return farm_; }
  /// "nats://host:4222/lab".
  [[nodiscard]] const std::string& place() const noexcept { return place_; }

  /// A connection to the farm as to a control socket. The error is one line: there is no descriptor left.
  [[nodiscard]] tl::expected<os::Descriptor, std::string> connect(Order order = Order::AsAsked);

  /// Asks the agents of the farm who they are, and waits. The error, of no connection to the server, is one line.
  [[nodiscard]] tl::expected<std::vector<AgentBeat>, std::string> agents();

  /// Has @p job done with what the server keeps (Link::run()), and waits for its end. The error is one line.
  template <class Result>
  [[nodiscard]] tl::expected<Result, std::string> store(
      std::function<tl::expected<Result, std::string>(Storage&)> job) {
    std::promise<tl::expected<Result, std::string>> promise;
    const auto done = [&promise](tl::expected<Result, std::string> result) {
      promise.set_value(std::move(result));
    };
    in_contact([&job, done](tl::expected<Link*, std::string> link) {
      if (!link) return done(tl::unexpected{link.error()});
      (*link)->run<Result>(std::move(job), done);
    });
    return promise.get_future().get();
  }

 private:
  class Work;

  /// Has @p then called in the thread as soon as it is known whether there is a connection.
  void in_contact(std::function<void(tl::expected<Link*, std::string>)> then);

  std::string farm_;
  std::string place_;
  std::unique_ptr<Work> work_;
};

}  // namespace farm
