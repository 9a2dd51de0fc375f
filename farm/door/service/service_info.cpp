#include "farm/door/service/service_info.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "farm/naming/subjects.hpp"

namespace farm {

namespace {

using nlohmann::json;

constexpr std::string_view kName = "axisd";

/// In the order of ServiceQuestion: word of the subject, and type of the answer.
struct QuestionRow {
  std::string_view word;
  std::string_view type;
};
constexpr std::array<QuestionRow, 3> kRows{{{"PING", "io.nats.micro.v1.ping_response"},
                                            {"INFO", "io.nats.micro.v1.info_response"},
                                            {"STATS", "io.nats.micro.v1.stats_response"}}};

const QuestionRow& row_of(ServiceQuestion question) noexcept {
  return kRows[static_cast<std::size_t>(question)];
}

json endpoint_of(const ServiceInfo& info, const UnitName& unit) {
  return {{"name", unit.bus + '_' + unit.node}, {"subject", rpc_subject(info.farm, unit)}, {"queue_group", ""}};
}

json described(const ServiceInfo& info, const Reached& reached) {
  json endpoint = endpoint_of(info, reached.unit.name);
  endpoint["metadata"] = {{"unit", reached.unit.name.text()},
                          {"profile", reached.unit.profile},
                          {"axes", std::to_string(reached.unit.axes)}};
  return endpoint;
}

json counted(const ServiceInfo& info, const UnitName& unit, const Rpc::Count& count) {
  json endpoint = endpoint_of(info, unit);
  endpoint["num_requests"] = count.requests;
  endpoint["num_errors"] = count.errors;
  endpoint["last_error"] = count.last_error;
  endpoint["processing_time"] = count.time.count();
  endpoint["average_processing_time"] =
      count.requests == 0 ? 0 : count.time.count() / static_cast<std::int64_t>(count.requests);
  return endpoint;
}

}  // namespace

std::array<std::string, 3> service_subjects(ServiceQuestion question, std::string_view id) {
  const std::string all = fmt::format("$SRV.{}", row_of(question).word);
  return {all, fmt::format("{}.{}", all, kName), fmt::format("{}.{}.{}", all, kName, id)};
}

std::string service_answer(ServiceQuestion question, const ServiceInfo& info, const Roster& roster,
                           const std::map<UnitName, Rpc::Count>& counts) {
  json answer{{"type", row_of(question).type},
              {"name", kName},
              {"id", info.id},
              {"version", info.version},
              {"metadata", {{"farm", info.farm}, {"host", info.host}}}};
  if (question == ServiceQuestion::Info) {
    answer["description"] = fmt::format("units of axisd on {}", info.host);
    answer["endpoints"] = json::array();
    for (const auto& [name, reached] : roster.units()) answer["endpoints"].push_back(described(info, reached));
  }
  if (question == ServiceQuestion::Stats) {
    answer["started"] = info.started;
    answer["endpoints"] = json::array();
    for (const auto& [name, reached] : roster.units()) {
      const auto count = counts.find(name);
      answer["endpoints"].push_back(counted(info, name, count != counts.end() ? count->second : Rpc::Count{}));
    }
  }
  return answer.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace farm
