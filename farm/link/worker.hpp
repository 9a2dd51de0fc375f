#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "farm/link/link.hpp"
#include "farm/link/requests.hpp"
#include "farm/link/session.hpp"
#include "farm/link/watch.hpp"
#include "farm/storage/job_thread.hpp"

namespace farm {

/// What a Link does with its session.
class Link::Worker final : private Session::Listener {
 public:
  Worker(axisd::ServiceEvents& events, const nats::Server& server, const std::string& client,
         Link::Listener& listener);
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker() override;

  [[nodiscard]] bool is_up() const noexcept { return session_.is_up(); }
  void publish(std::string_view subject, std::string_view data);
  void subscribe(const std::string& subject, OnMessage on_message);
  void unsubscribe(const std::string& subject);
  void drain(const std::string& subject);
  void request(std::string_view subject, std::string_view data, std::chrono::milliseconds patience,
               OnReply on_reply);
  void run_job(Job job, std::function<void()> then);
  void watch(std::unique_ptr<Watch> watch);

 private:
  struct Subscribed {
    std::string subject;
    std::shared_ptr<const OnMessage> on_message;
    nats::Subscription subscription;  ///< of the present connection
  };

  struct Watched {
    std::unique_ptr<Watch> watch;
    std::uint64_t id = 0;             ///< of its present beginning
    nats::Subscription subscription;  ///< of that
  };

  void on_contact() override;
  void on_up() override;
  void on_down(const std::string& why) override;
  void on_message(std::uint64_t id, natsMsg* message) override;
  void on_end(std::uint64_t id) override { drained_.erase(id); }
  void on_tick() override;

  void take_answer(natsMsg* message);
  void advance_requests();
  void begin(Watched& watched);
  void ask_for(Watched& watched);
  [[nodiscard]] Watch* watch_of(std::uint64_t id) const noexcept;

  Link::Listener& listener_;
  std::string inbox_;  ///< in front of a dot and a token
  nats::Subscription inbox_subscription_;
  std::map<std::uint64_t, Subscribed> subscriptions_;  ///< by their numbers for the session
  std::map<std::uint64_t, Subscribed> drained_;        ///< that are no more, but for what is on its way to them
  std::uint64_t last_id_;
  Requests requests_;
  axisd::EventSource request_timer_;
  std::list<Watched> watches_;
  JobThread jobs_;
  axisd::EventSource on_job_;
  Session session_;
};

}  // namespace farm
