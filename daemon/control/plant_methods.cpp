#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "control/methods.hpp"
#include "daemon/control/handlers.hpp"
#include "daemon/instance/instance.hpp"

namespace axisd {
namespace {

using nlohmann::json;

std::size_t axis_of(const json& params) {
  return params.at("axis").get<std::size_t>();
}

Outcome set_load(const Call& call, const json& params) {
  const bool is_friction = params.value("type", "constant") == "friction";
  call.instance.set_load_torque(axis_of(params), params.at("torque_Nm").get<double>(),
                                is_friction ? motor::LoadTorqueType::Friction : motor::LoadTorqueType::Constant,
                                call.now);
  return json::object();
}

Outcome set_supply(const Call& call, const json& params) {
  call.instance.device().set_line_voltage(params.at("line_voltage_V").get<double>(), call.now);
  return json::object();
}

struct DefectName {
  motor::EncoderDefect defect;
  std::string_view name;
};
constexpr std::array kDefects{DefectName{motor::EncoderDefect::None, "none"},
                              DefectName{motor::EncoderDefect::Loss, "loss"},
                              DefectName{motor::EncoderDefect::LostPulses, "lost_pulses"},
                              DefectName{motor::EncoderDefect::Reversed, "reversed"}};
static_assert(std::ranges::equal(kDefects, control::parameter_of("encoder.fail", "defect").choices, {},
                                 &DefectName::name));

Outcome fail_encoder(const Call& call, const json& params) {
  const auto* const row = std::ranges::find(kDefects, params.at("defect").get<std::string>(), &DefectName::name);
  call.instance.device().fail_encoder(axis_of(params), row->defect, call.now);
  return json::object();
}

constexpr std::array kPlantHandlers{
    Handler{"load.set", &set_load},
    Handler{"supply.set", &set_supply},
    Handler{"encoder.fail", &fail_encoder},
};

}  // namespace

std::span<const Handler> plant_handlers() noexcept {
  return kPlantHandlers;
}

}  // namespace axisd
