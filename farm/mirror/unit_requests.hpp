#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "control/error.hpp"
#include "farm/link/messages.hpp"
#include "farm/mirror/directory.hpp"

namespace farm {

/// Requests on their way to units and back.
class UnitRequests {
 public:
  /// The line that answers, with its newline.
  using OnLine = std::function<void(std::string line)>;
  /// What is asked, of which unit.
  struct Request {
    Directory::Entry unit;
    nlohmann::json id{};  ///< handed back in the line
    std::string method{};
    nlohmann::json params = nlohmann::json::object();
    std::string deliver{};  ///< subject for what is subscribed to; empty: none
  };

  /// To units of @p farm, which have @p patience to answer in. @p messages outlives it.
  UnitRequests(Messages& messages, std::string farm, std::chrono::milliseconds patience)
      : messages_{messages}, farm_{std::move(farm)}, patience_{patience} {}
  UnitRequests(const UnitRequests&) = delete;
  UnitRequests& operator=(const UnitRequests&) = delete;
  ~UnitRequests() = default;

  /// Asks; @p on_line is told once: what the unit answers, as it came, or why there is no answer.
  void ask(Request request, OnLine on_line);
  /// Whoever waits for a unit of @p host is told that it is silent.
  void give_up(const std::string& host);

 private:
  struct UnderWay {
    Request request;
    OnLine on_line;
  };
  void take(std::uint64_t number, const Messages::Reply& reply);
  [[nodiscard]] std::string line_of(const Request& request, const Messages::Reply& reply) const;

  Messages& messages_;
  std::string farm_;
  std::chrono::milliseconds patience_;
  /// Goes with this: a reply may come later.
  std::shared_ptr<bool> life_ = std::make_shared<bool>();
  std::map<std::uint64_t, UnderWay> under_way_;
  std::uint64_t last_ = 0;
};

/// A refusal that says that something of the farm does not answer.
[[nodiscard]] control::Error unreachable(std::string message);

}  // namespace farm
