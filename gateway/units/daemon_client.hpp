#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "gateway/base/error.hpp"
#include "gateway/units/line_connection.hpp"

namespace gateway {

/// What a daemon has answered.
using Answer = tl::expected<nlohmann::json, Error>;
/// Who waits for an answer; called once, whatever happens.
using OnAnswer = std::function<void(Answer)>;

/// Requests to one daemon over one connection, any number under way; and what the daemon tells unasked.
class DaemonClient final : private LineConnection::Listener {
 public:
  /// Most requests that wait for an answer.
  static constexpr std::size_t kMostWaiting = 4096;

  /// Who hears.
  class Listener {
   public:
    virtual ~Listener() = default;
    /// The daemon tells @p value under @p key: "event", "sample".
    virtual void on_notice(DaemonClient& client, std::string_view key, const nlohmann::json& value) = 0;
    /// The same, as it came and before it is looked at: @p value is the text of an object in one line. False: it
    /// is to be told by the other call.
    virtual bool on_notice_text(DaemonClient& client, std::string_view key, std::string_view value) {
      static_cast<void>(client), static_cast<void>(key), static_cast<void>(value);
      return false;
    }
    /// The connection has ended for the reason @p why; the client may be destroyed in the call.
    virtual void on_gone(DaemonClient& client, const std::string& why) = 0;
  };

  /// Speaks to the daemon at the other end of @p socket, a stream that does not block; @p path is what it is
  /// called.
  /// @p events and @p listener outlive it. Throws std::system_error.
  DaemonClient(axisd::ServiceEvents& events, std::string path, os::Descriptor socket, Listener& listener);
  DaemonClient(const DaemonClient&) = delete;
  DaemonClient& operator=(const DaemonClient&) = delete;
  /// Whoever waits is told that there is no daemon.
  ~DaemonClient() override;

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  /// Asks for @p method; @p on_answer is told, at once if it cannot be asked.
  void ask(std::string_view method, const nlohmann::json& params, OnAnswer on_answer);
  /// Whether the daemon owes an answer since more than 10 s.
  [[nodiscard]] bool is_silent() const noexcept;
  /// Ends the connection: whoever waits is told @p why.
  void give_up(const Error& why);

 private:
  struct Waiting {
    int id;
    std::int64_t since;  ///< µs, monotonic
    OnAnswer on_answer;
  };

  std::string on_line(std::string_view line) override;
  void on_closed(const std::string& why) override;
  std::deque<Waiting>::iterator waiting_for(const nlohmann::json& answer);
  void take_answer(std::deque<Waiting>::iterator waiting, Answer answer);

  std::string path_;
  Listener& listener_;
  std::unique_ptr<LineConnection> connection_;
  std::deque<Waiting> waiting_;
  int last_id_ = 0;
};

}  // namespace gateway
