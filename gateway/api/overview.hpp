#pragma once

#include <memory>

#include "gateway/page/page_files.hpp"
#include "gateway/security/access.hpp"
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

/// Names what there is: @p page for a browser, or a list where there is no page; JSON for who asks for that.
[[nodiscard]] Response start_page(const Request& request, const PageFiles& page);

/// The file @p name of @p page.
[[nodiscard]] Response asset_of(const Request& request, std::string_view name, const PageFiles& page);

/// Tells what the gateway is, and what the token of @p request is to it.
[[nodiscard]] Response server_page(const AccessRules& rules, const Request& request);

}  // namespace gateway
