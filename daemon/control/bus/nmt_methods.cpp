// The node on its bus: NMT, error control, and what has become of frames.
#include <array>

#include "daemon/control/handlers.hpp"
#include "daemon/instance/instance.hpp"
#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/base/object_index.hpp"

namespace axisd {
namespace {

using nlohmann::json;

/// The stored number of an object; null if the unit has none.
json stored(const canopen::Dictionary& dictionary, std::uint16_t index, std::uint8_t sub_index = 0) {
  const auto value = dictionary.stored(index, sub_index);
  return value ? json(*value) : json();
}

json counters_json(const Instance& instance) {
  const auto& sent = instance.bus().queue().counters();
  return {{"received", instance.bus().received()},
          {"sent", sent.sent},
          {"queued", sent.queued},
          {"waiting", instance.bus().queue().waiting()},
          {"refused", sent.refused},
          {"replaced", sent.replaced},
          {"send_dropped", sent.dropped},
          {"dropped", instance.bus().port().dropped()},
          {"foreign", instance.reports().foreign_frames()},
          {"lost_telegrams", instance.device().lost_telegrams()},
          {"short_rpdos", instance.device().node().short_rpdos()},
          {"late_rpdos", instance.device().node().late_rpdos()}};
}

json error_control_json(const canopen::Dictionary& dictionary) {
  return {{"heartbeat_ms", stored(dictionary, canopen::object::kHeartbeatTime)},
          {"guard_time_ms", stored(dictionary, canopen::object::kGuardTime)},
          {"life_time_factor", stored(dictionary, canopen::object::kLifeTimeFactor)}};
}

Outcome show_node(const Call& call, const json&) {
  const Instance& instance = call.instance;
  const canopen::Node& node = instance.device().node();
  const canopen::Dictionary& dictionary = instance.device().dictionary();
  return json{{"node_id", node.node_id()},
              {"state", canopen::name_of(node.state())},
              {"error_register", stored(dictionary, canopen::object::kErrorRegister)},
              {"error_control", error_control_json(dictionary)},
              {"sync_cob_id", stored(dictionary, canopen::object::kCobIdSync)},
              {"emcy_cob_id", stored(dictionary, canopen::object::kCobIdEmcy)},
              {"valid_rpdos", node.valid_pdos(canopen::Direction::Receive)},
              {"valid_tpdos", node.valid_pdos(canopen::Direction::Transmit)},
              {"bus",
               {{"link", instance.bus().is_open() ? "up" : "down"},
                {"state", bus::name_of(instance.bus_state())},
                {"counters", counters_json(instance)}}}};
}

constexpr std::array kNmtHandlers{
    Handler{"nmt.get", &show_node},
};

}  // namespace

std::span<const Handler> nmt_handlers() noexcept {
  return kNmtHandlers;
}

}  // namespace axisd
