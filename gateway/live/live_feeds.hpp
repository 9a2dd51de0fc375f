#pragma once

#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "gateway/live/cursor.hpp"
#include "gateway/live/line_ring.hpp"
#include "gateway/server/exchange.hpp"
#include "gateway/units/daemons.hpp"

namespace gateway {

/// Tells the time by which is judged what is old.
using LiveClock = std::function<LiveTime()>;
/// The monotonic one.
[[nodiscard]] LiveTime live_time() noexcept;

/// Samples and frames of units for those who ask again and again for what has come since. All who ask for the same
/// share one subscription, which has a connection of its own and ends when nobody has asked for a while.
class LiveFeeds final : private DaemonClient::Listener {
 public:
  /// Most feeds of a kind at a daemon.
  static constexpr std::size_t kMostFeeds = 16;
  /// A feed that nobody has asked for so long ends.
  static constexpr LiveTime kPatience{5000};

  /// All outlive it; @p clock tells what is old.
  LiveFeeds(axisd::ServiceEvents& events, Daemons& daemons, LiveClock clock = live_time);
  LiveFeeds(const LiveFeeds&) = delete;
  LiveFeeds& operator=(const LiveFeeds&) = delete;
  ~LiveFeeds() override;

  /// Answers @p exchange by what has come of @p unit since the cursor in @p params (`signals`, `period_ms`,
  /// `frames`, `after`), or by the daemon's refusal; a feed that is not there yet begins.
  void answer(const std::shared_ptr<Exchange>& exchange, const std::string& unit, const nlohmann::json& params);
  /// Ends what nobody asks for any more; it is called each second.
  void sweep();
  /// How many feeds there are.
  [[nodiscard]] std::size_t size() const noexcept { return feeds_.size(); }

 private:
  enum class What : std::uint8_t { Samples, Frames };
  struct Feed {
    What what;
    nlohmann::json params;  ///< of the subscription
    std::uint64_t number;
    std::unique_ptr<DaemonClient> client;
    LiveTime asked;
    bool is_granted = false;
    std::optional<Error> refusal{};  ///< it has none to come, and ends
    LineRing lines{};
  };
  /// Who waits for an answer.
  struct Poll {
    std::shared_ptr<Exchange> exchange;
    std::optional<Cursor> after;
    std::vector<std::uint64_t> feeds{};  ///< numbers
  };

  bool on_notice_text(DaemonClient& client, std::string_view key, std::string_view value) override;
  void on_notice(DaemonClient& client, std::string_view key, const nlohmann::json& value) override;
  void on_gone(DaemonClient& client, const std::string& why) override;

  /// The feed that is asked for, from now on if there was none.
  tl::expected<Feed*, Error> feed_of(What what, const nlohmann::json& params);
  tl::expected<Feed*, Error> begin(What what, const nlohmann::json& params, const std::string& path);
  void take_answer(const DaemonClient& client, const Answer& answer);
  /// Answers those for whom all is there.
  void settle();
  bool settle(const Poll& poll);
  Feed* find(const DaemonClient& client) noexcept;
  Feed* find(std::uint64_t number) noexcept;
  void sweep_soon();

  axisd::ServiceEvents& events_;
  Daemons& daemons_;
  LiveClock clock_;
  std::uint64_t last_number_;
  std::list<Feed> feeds_;
  std::list<Poll> polls_;
  axisd::EventSource sweep_;  ///< a timer
};

}  // namespace gateway
