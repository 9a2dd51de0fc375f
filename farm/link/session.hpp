#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "can/nats/connector.hpp"
#include "farm/link/contact.hpp"
#include "service/service_events.hpp"

namespace farm {

/// The connection to a server, one after the other, in the loop of a program: it looks after the sockets, and by
/// beats after the server.
class Session {
 public:
  /// Who hears.
  class Listener {
   public:
    virtual ~Listener() = default;
    /// There is a new connection, which knows no subscription yet.
    virtual void on_contact() = 0;
    /// Messages come and go.
    virtual void on_up() = 0;
    /// They do no longer, or the first attempt has failed. Once until on_up().
    virtual void on_down(const std::string& why) = 0;
    /// @p message has come for the subscription @p id.
    virtual void on_message(std::uint64_t id, natsMsg* message) = 0;
    /// The last one has come for it.
    virtual void on_end(std::uint64_t id) = 0;
    /// A kBeat has passed while it is up.
    virtual void on_tick() = 0;
  };

  /// Between two beats.
  static constexpr std::chrono::milliseconds kBeat{250};
  /// Beats without an answer after which the connection is given up.
  static constexpr int kMostBeats = 4;

  /// Begins to connect; @p make connects, on a thread. std::system_error if the kernel gives no descriptor or
  /// thread.
  Session(axisd::ServiceEvents& events, nats::Connector<Contact>::Make make, std::size_t most_unsent,
          Listener& listener);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session() = default;

  [[nodiscard]] bool is_up() const noexcept { return is_up_; }
  /// False if it is not sent: there is no connection, or too much waits.
  bool publish(const std::string& subject, const std::string& reply, std::string_view data);
  /// Of the present connection; nullptr: there is none, or it is given up for want of this one. @p id is above 0.
  [[nodiscard]] nats::Subscription subscribe(std::uint64_t id, const std::string& subject);
  /// Ends @p subscription when all has come that is on its way; false if it may end at once.
  [[nodiscard]] bool drain(const nats::Subscription& subscription);

 private:
  using Handler = void (Session::*)(std::uint32_t events);
  template <Handler kHandler>
  [[nodiscard]] axisd::EventSource watch(int descriptor);

  void accept(std::uint32_t events);
  void serve_socket(std::uint32_t events);
  void serve_arrivals(std::uint32_t events);
  void tell(const Arrivals::Arrival& arrival);
  void write();
  void look_after();
  void on_beat();
  void lose(const std::string& why);
  void tell_down(const std::string& why);

  axisd::ServiceEvents& events_;
  std::size_t most_unsent_;
  Listener& listener_;
  std::string beat_subject_;
  std::unique_ptr<Contact> contact_;
  nats::Subscription beat_;
  bool is_up_ = false;
  bool is_told_down_ = false;
  bool is_watched_for_room_ = false;
  bool is_taking_ = false;  ///< what is published is written when all that came was taken
  std::string defect_;      ///< why the present connection is to be given up
  int beats_ = 0;           ///< that were sent since the server has given a sign
  nats::Connector<Contact> connector_;
  axisd::EventSource on_connector_;
  axisd::EventSource on_socket_;
  axisd::EventSource on_arrival_;
  axisd::EventSource timer_;
};

}  // namespace farm
