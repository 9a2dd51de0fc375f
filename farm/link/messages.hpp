#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace farm {

/// A message that has come. The texts live until the call ends.
struct Message {
  std::string_view subject;
  std::string_view reply;  ///< empty: nobody waits for an answer
  std::string_view data;
};

/// Why a request has no answer.
enum class NoReply : std::uint8_t {
  Down,     ///< there is no connection, or it was lost before the answer came
  Nobody,   ///< nobody listens at the subject
  TooLate,  ///< no answer in time
  TooMuch,  ///< as many requests wait as may
};
[[nodiscard]] std::string_view text_of(NoReply why) noexcept;

/// Messages over a server, as far as there is a connection to it. All calls and all callbacks belong to one
/// thread.
///
/// What is published while there is no connection is dropped, and nothing is sent a second time: who speaks to
/// units wants no old message to arrive.
class Messages {
 public:
  using OnMessage = std::function<void(const Message&)>;
  using Reply = tl::expected<std::string, NoReply>;
  using OnReply = std::function<void(Reply)>;

  Messages() = default;
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;
  virtual ~Messages() = default;

  [[nodiscard]] virtual bool is_up() const noexcept = 0;

  /// Sends @p data to @p subject; nothing happens while there is no connection.
  virtual void publish(std::string_view subject, std::string_view data) = 0;
  /// Hands every message of @p subject, which may have wildcards, to @p on_message, until unsubscribe(), over
  /// all connections.
  virtual void subscribe(const std::string& subject, OnMessage on_message) = 0;
  virtual void unsubscribe(const std::string& subject) = 0;
  /// The same, but what is on its way is still handed over: who answers requests leaves none without an answer.
  virtual void drain(const std::string& subject) = 0;
  /// Asks whoever listens at @p subject; @p on_reply is told once, at once if it cannot be asked.
  virtual void request(std::string_view subject, std::string_view data, std::chrono::milliseconds patience,
                       OnReply on_reply) = 0;
};

}  // namespace farm
