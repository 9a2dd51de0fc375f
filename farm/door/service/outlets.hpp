#pragma once

#include <chrono>
#include <list>
#include <memory>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "farm/link/messages.hpp"
#include "farm/naming/unit_name.hpp"
#include "gateway/units/daemons.hpp"

namespace farm {

/// What units tell to the subjects that clients have named: for each unit and subject one connection to its
/// daemon, until the client ends it or has said nothing for 10 s.
class Outlets final : private gateway::DaemonClient::Listener {
 public:
  /// Most of one daemon, which has 64 clients at a time.
  static constexpr std::size_t kMostOfDaemon = 32;
  /// A client that has said nothing for so long is gone.
  static constexpr std::chrono::seconds kPatience{10};

  /// Where the unit is.
  struct Source {
    UnitName unit;
    std::string name;  ///< as its daemon calls it
    std::string path;  ///< of the control socket
  };

  /// From @p daemons to @p messages; both outlive it.
  Outlets(gateway::Daemons& daemons, Messages& messages) : daemons_{daemons}, messages_{messages} {}
  Outlets(const Outlets&) = delete;
  Outlets& operator=(const Outlets&) = delete;
  ~Outlets() override;

  /// Whether a client may have something told to @p subject: it is one, and of neither the server nor the farm.
  [[nodiscard]] static bool is_subject(std::string_view subject) noexcept;

  /// Asks @p source for @p method, which subscribes, for the client at @p subject; @p on_answer is told once.
  void subscribe(const Source& source, const std::string& subject, std::string_view method,
                 const nlohmann::json& params, gateway::OnAnswer on_answer);
  /// The client at @p subject asks for @p method of what it has; false: it has nothing of @p unit.
  [[nodiscard]] bool ask(const UnitName& unit, std::string_view subject, std::string_view method,
                         const nlohmann::json& params, gateway::OnAnswer on_answer);
  /// The client is there still; false: it has nothing of @p unit.
  [[nodiscard]] bool keep(const UnitName& unit, std::string_view subject) noexcept;
  /// It wants nothing more; false: it had nothing of @p unit.
  [[nodiscard]] bool end(const UnitName& unit, std::string_view subject);
  void end_all() { all_.clear(); }
  /// Ends those of clients that are gone; to be called about once a second.
  void sweep();

 private:
  using Time = std::chrono::nanoseconds;
  struct Outlet {
    Source source;
    std::string subject;
    Time heard{};
    std::unique_ptr<gateway::DaemonClient> client{};
  };

  bool on_notice_text(gateway::DaemonClient& client, std::string_view key, std::string_view value) override;
  void on_notice(gateway::DaemonClient& client, std::string_view key, const nlohmann::json& value) override;
  void on_gone(gateway::DaemonClient& client, const std::string& why) override;
  [[nodiscard]] Outlet* find(const UnitName& unit, std::string_view subject) noexcept;
  [[nodiscard]] Outlet* find(const gateway::DaemonClient& client) noexcept;
  [[nodiscard]] tl::expected<Outlet*, gateway::Error> open(const Source& source, const std::string& subject);

  gateway::Daemons& daemons_;
  Messages& messages_;
  std::list<Outlet> all_;
};

}  // namespace farm
