#pragma once

#include <memory>

#include "gateway/server/counters.hpp"
#include "gateway/server/exchange.hpp"
#include "gateway/units/daemons.hpp"

namespace gateway {

/// Answers @p exchange by the units of all daemons, and by what their control sockets count.
void answer_units(const std::shared_ptr<Exchange>& exchange, const Daemons& daemons);

/// Answers @p exchange by the metrics of all units and by those of the gateway, as Prometheus reads them.
void answer_metrics(const std::shared_ptr<Exchange>& exchange, const Daemons& daemons, const Counters& counters);

/// Answers @p exchange by the axis of the path out of the `status` of its unit.
void answer_axis(const std::shared_ptr<Exchange>& exchange, const std::string& axis, const Answer& status);

/// Names what there is: a page for people, or JSON for who asks for that.
[[nodiscard]] Response start_page(const Request& request);

}  // namespace gateway
