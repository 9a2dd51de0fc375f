#include "daemon/instance/metrics.hpp"

#include <chrono>

#include <fmt/format.h>

#include "daemon/instance/instance.hpp"

namespace axisd {
namespace {

using nlohmann::json;

double seconds(canopen::Duration time) noexcept {
  return std::chrono::duration<double>{time}.count();
}

json histogram(const Histogram& times) {
  json bounds = json::array();
  for (const canopen::Duration bound : Histogram::kBounds) bounds.push_back(seconds(bound));
  return {{"bounds", std::move(bounds)}, {"counts", times.counts()}, {"sum", seconds(times.sum())}};
}

json cycles(const Instance& instance) {
  const unit::Runner& runner = instance.device().runner();
  const CycleTimes& times = instance.cycle_times();
  return {{"period_s", seconds(instance.device().cycle())},
          {"run", runner.clock().run()},
          {"skipped", runner.skipped_cycles()},
          {"overruns", times.overruns()},
          {"duration_s", histogram(times.duration())},
          {"lateness_s", histogram(times.lateness())}};
}

json sdo_server(const canopen::SdoAnswerCounters& answers, std::size_t number) {
  json aborts = json::array();
  for (const auto& [code, count] : answers.aborts())
    aborts.push_back({{"code", fmt::format("0x{:08X}", static_cast<std::uint32_t>(code))}, {"count", count}});
  return {{"server", number}, {"frames", answers.frames()}, {"aborts", std::move(aborts)}};
}

json sdo_servers(const canopen::Node& node) {
  json servers = json::array();
  for (std::size_t number = 0; number < node.sdo_servers(); ++number)
    servers.push_back(sdo_server(node.sdo_answers(number), number));
  return servers;
}

/// Faults and alarms that @p object has had, in the order of their numbers.
void add_messages(json& list, const drive::DriveObject& object) {
  const auto entered = object.messages().entered();
  for (std::size_t i = 0; i < entered.size(); ++i) {
    const auto add = [&](const char* kind_name, drive::Kind kind, std::uint32_t count) {
      if (count == 0) return;
      list.push_back({{"drive_object", object.number()},
                      {"kind", kind_name},
                      {"code", message_code(drive::fault_rows()[i].number, kind)},
                      {"count", count}});
    };
    add("fault", drive::Kind::Fault, entered[i].as_fault);
    add("alarm", drive::Kind::Alarm, entered[i].as_alarm);
  }
}

json messages(const drive::DriveUnit& unit) {
  json list = json::array();
  unit.for_each_object([&](const drive::DriveObject& object) { add_messages(list, object); });
  return list;
}

}  // namespace

json metrics_of(const Instance& instance) {
  const bus::TransmitQueue::Counters& sent = instance.bus().queue().counters();
  return {{"uptime_s", instance.uptime_s()},
          {"frames", {{"received", instance.bus().received()}, {"sent", sent.sent}}},
          {"cycles", cycles(instance)},
          {"sdo", sdo_servers(instance.device().node())},
          {"messages", messages(instance.device().unit())}};
}

}  // namespace axisd
