#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "can/nats/server.hpp"
#include "farm/link/messages.hpp"
#include "farm/storage/key_value.hpp"
#include "farm/storage/object_store.hpp"
#include "service/service_events.hpp"

namespace farm {

/// A connection to a NATS server that is made again whenever it is lost, for a program whose thread runs sd-event:
/// that thread is never kept waiting, neither by a server that is slow nor by one that stands still. All calls and
/// all callbacks belong to it.
class Link final : public Messages {
 public:
  /// Who is told how the connection is.
  class Listener {
   public:
    virtual ~Listener() = default;
    /// Messages come and go; subscriptions have been made again before.
    virtual void on_up() = 0;
    /// They do no longer, or the first attempt has failed; @p why is one line. Once until on_up().
    virtual void on_down(const std::string& why) = 0;
  };

  /// Most requests that wait for an answer.
  static constexpr std::size_t kMostRequests = 1024;
  /// Most that may wait to be sent (bytes); what is more is dropped.
  static constexpr std::size_t kMostUnsent = 4UL * 1024 * 1024;
  /// Without a sign of the server for so long the connection is given up.
  static constexpr std::chrono::milliseconds kPatience{1000};

  /// Begins to connect to @p server, which sees it under the name @p client; @p events and @p listener outlive it.
  /// Throws std::system_error if the kernel gives no descriptor or thread.
  Link(axisd::ServiceEvents& events, const nats::Server& server, const std::string& client, Listener& listener);
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  /// Whoever waits is told NoReply::Down.
  ~Link() override;

  [[nodiscard]] bool is_up() const noexcept override;

  void publish(std::string_view subject, std::string_view data) override;
  void subscribe(const std::string& subject, OnMessage on_message) override;
  void unsubscribe(const std::string& subject) override;
  void drain(const std::string& subject) override;
  void request(std::string_view subject, std::string_view data, std::chrono::milliseconds patience,
               OnReply on_reply) override;

  /// Has @p job done with the key-value buckets and object stores of the server, on a thread of its own, one job
  /// after the other; @p then is told afterwards, here. The job may wait for the server, as long as the calls in
  /// it do (2 s each at most); it throws nothing and touches nothing that others use. It fails with "no
  /// connection" if there is none.
  template <class Result>
  void run(std::function<tl::expected<Result, std::string>(Storage&)> job,
           std::function<void(tl::expected<Result, std::string>)> then) {
    auto result =
        std::make_shared<tl::expected<Result, std::string>>(tl::unexpected{std::string{"no connection"}});
    run_job(
        [job = std::move(job), result](Storage* storage) {
          if (storage != nullptr) *result = job(*storage);
        },
        [then = std::move(then), result] { then(std::move(*result)); });
  }
  /// Tells every change of the keys of @p bucket that @p pattern names (">": all) to @p on_entry, those that are
  /// there first; @p on_all is told when these have been told, after every connection anew. The bucket is made if
  /// there is none. Never ends.
  void watch(const std::string& bucket, const std::string& pattern, std::function<void(const Entry&)> on_entry,
             std::function<void()> on_all);

 private:
  using Job = std::function<void(Storage*)>;
  void run_job(Job job, std::function<void()> then);

  class Worker;
  std::unique_ptr<Worker> worker_;
};

}  // namespace farm
