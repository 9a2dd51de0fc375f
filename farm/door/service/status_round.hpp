#pragma once

#include <memory>
#include <set>
#include <string>

#include "farm/door/service/roster.hpp"
#include "farm/link/messages.hpp"
#include "gateway/units/daemons.hpp"

namespace farm {

/// Publishes what every unit does, once a second, a part of the units at a time so that many of them make no
/// burst.
class StatusRound {
 public:
  /// Steps that a second has.
  static constexpr std::size_t kSteps = 20;

  /// For the host called @p host of the farm @p farm. The other arguments outlive it.
  StatusRound(std::string farm, std::string host, Messages& messages, const gateway::Daemons& daemons,
              const Roster& roster)
      : farm_{std::move(farm)}, host_{std::move(host)}, messages_{messages}, daemons_{daemons}, roster_{roster} {}

  /// Asks the units whose turn it is; to be called kSteps times a second.
  void step();

 private:
  void ask(const Reached& reached);

  std::string farm_;
  std::string host_;
  Messages& messages_;
  const gateway::Daemons& daemons_;
  const Roster& roster_;
  std::size_t step_ = 0;
  /// Units that owe an answer; shared so that who answers when the door has closed sees it.
  std::shared_ptr<std::set<UnitName>> asked_ = std::make_shared<std::set<UnitName>>();
};

}  // namespace farm
