#include "farm/door/service/rpc.hpp"

#include <utility>

#include <fmt/format.h>

#include "farm/door/service/access.hpp"
#include "farm/door/service/answers.hpp"
#include "os/clock.hpp"

namespace farm {

namespace {

using control::ErrorCode;
using nlohmann::json;

/// The member `deliver` of @p request; empty if it is no text.
std::string deliver_of(std::string_view request) {
  if (request.find("\"deliver\"") == std::string_view::npos) return {};
  const json object = control::parse_line(request);
  const json deliver = object.is_object() ? object.value("deliver", json{}) : json{};
  return deliver.is_string() ? deliver.get<std::string>() : "";
}

}  // namespace

/// A request that has come.
struct Rpc::Asked {
  UnitName unit;
  std::string reply;
  std::string deliver;
  json id;
  std::chrono::nanoseconds since;
};

void Rpc::take(const UnitName& unit, const Message& message) {
  Asked asked{unit, std::string{message.reply}, {}, {}, os::monotonic_time()};
  ++(*counts_)[unit].requests;
  if (message.data.size() > kLongest)
    return refuse(asked, ErrorCode::Overflow, fmt::format("the request is longer than {} bytes", kLongest));
  auto request = control::parse_request(message.data);
  if (!request) {
    asked.id = std::move(request.error().id);
    return refuse(asked, request.error().error.code, std::move(request.error().error.message));
  }
  asked.id = std::move(request->id);
  asked.deliver = deliver_of(message.data);
  carry_out(asked, *std::move(request));
}

void Rpc::carry_out(const Asked& asked, control::Request request) {
  const Reached* const reached = parts_.roster.find(asked.unit);
  if (reached == nullptr)
    return answer(asked, tl::unexpected{gateway::refuse(gateway::Refused::NoDaemon,
                                                        fmt::format("{} is gone", asked.unit.text()))});
  if (request.method == "units") return answer(asked, unit_list(*reached));
  if (request.method == "quit")
    return refuse(asked, ErrorCode::Refused, "a unit of a farm is not ended over the farm");
  if (request.method == "keep" || request.method == "end" || is_subscription(request.method))
    return serve_outlet(asked, request);
  if (read_only_ && !is_read(request.method, request.params))
    return refuse(asked, ErrorCode::Refused,
                  fmt::format("{}: the door of {} is open for reading only (--read-only)", request.method, host_));
  forward(asked, *reached, request);
}

void Rpc::serve_outlet(const Asked& asked, const control::Request& request) {
  if (!Outlets::is_subject(asked.deliver))
    return refuse(asked, ErrorCode::BadParameter,
                  "deliver: expected the subject of the client to which it is to be told");
  Outlets& outlets = parts_.outlets;
  const auto on_answer = [this, asked, alive = std::weak_ptr{counts_}](const gateway::Answer& told) {
    if (!alive.expired()) answer(asked, told);
  };
  if (begins_subscription(request.method)) {
    const std::string& name = parts_.roster.find(asked.unit)->name;
    const auto daemon = parts_.daemons.find(name);
    if (!daemon) return answer(asked, tl::unexpected{daemon.error()});
    return outlets.subscribe({asked.unit, name, (*daemon)->path()}, asked.deliver, request.method, request.params,
                             on_answer);
  }
  if (is_subscription(request.method) &&
      outlets.ask(asked.unit, asked.deliver, request.method, request.params, on_answer))
    return;
  if (request.method == "keep" && outlets.keep(asked.unit, asked.deliver)) return answer(asked, json::object());
  if (request.method == "end" && outlets.end(asked.unit, asked.deliver)) return answer(asked, json::object());
  refuse(asked, ErrorCode::NotFound, fmt::format("nothing is told to {}", asked.deliver));
}

void Rpc::forward(const Asked& asked, const Reached& reached, control::Request& request) {
  const auto daemon = parts_.daemons.find(reached.name);
  if (!daemon) return answer(asked, tl::unexpected{daemon.error()});
  if (*under_way_ >= kMostUnderWay)
    return refuse(asked, ErrorCode::Overflow, fmt::format("{} requests are under way at this door", *under_way_));
  request.params["unit"] = reached.name;
  ++*under_way_;
  (*daemon)->ask(request.method, request.params,
                 [this, asked, alive = std::weak_ptr{under_way_}](const gateway::Answer& told) {
                   const auto count = alive.lock();
                   if (!count) return;  // the door is closed
                   --*count;
                   answer(asked, told);
                 });
}

json Rpc::unit_list(const Reached& reached) const {
  const DoorUnit& unit = reached.unit;
  return {{"units", json::array({{{"unit", unit.name.text()},
                                  {"host", host_},
                                  {"interface", reached.interface},
                                  {"node_id", unit.node_id},
                                  {"profile", unit.profile},
                                  {"axes", unit.axes},
                                  {"on", unit.is_on}}})}};
}

void Rpc::answer(const Asked& asked, const gateway::Answer& told) const {
  Count& count = (*counts_)[asked.unit];
  count.time += os::monotonic_time() - asked.since;
  if (!told) {
    ++count.errors;
    count.last_error = told.error().message;
  }
  if (!asked.reply.empty()) parts_.messages.publish(asked.reply, answer_text(asked.id, told));
}

void Rpc::refuse(const Asked& asked, control::ErrorCode code, std::string message) const {
  answer(asked, tl::unexpected{gateway::refused_by_daemon(code, std::move(message), nullptr)});
}

}  // namespace farm
