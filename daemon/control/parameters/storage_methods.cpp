// Saving the parameters and taking them back.
#include <array>

#include "daemon/control/handlers.hpp"
#include "daemon/control/parameters/parameter_write.hpp"
#include "daemon/control/place.hpp"
#include "daemon/instance/instance.hpp"
#include "libcanopen/base/object_index.hpp"
#include "libcanopen/storage/storage_objects.hpp"

namespace axisd {
namespace {

using control::ErrorCode;
using nlohmann::json;

constexpr std::string_view kSaveAll = "p0977";
constexpr std::string_view kReset = "p0972";

json status_of_storage(const Instance& instance) {
  const Instance::Saves& saves = instance.saves();
  json status{{"is_saving", instance.device().is_saving()},
              {"is_stored", instance.device().is_stored()},
              {"file", instance.memory().parameters_text()},
              {"saves", saves.ended}};
  if (saves.ended != 0) status["last_kept"] = saves.kept;
  return status;
}

/// A command parameter of the control unit.
Taken<void> command(const Call& call, std::string_view name) {
  drive::DriveUnit& unit = unit_of(call);
  const auto target = find_parameter_target(unit, &unit.control_unit(), name);
  if (!target) return tl::unexpected{target.error()};
  return write_and_tell(call, *target, 1.0);
}

/// Saves all that the device can save.
Taken<void> begin_save(const Call& call) {
  if (call.instance.has_parameters()) return command(call, kSaveAll);
  device::Device& device = call.instance.device();
  if (!device.is_on()) return tl::unexpected{unit_is_off()};
  const canopen::Entry* const entry = device.dictionary().lookup(canopen::object::kStoreParameters, 1);
  const auto written = device.write_object(*entry, std::int64_t{canopen::kSaveSignature}, call.now);
  if (!written) return tl::unexpected{control::Error{ErrorCode::Refused, "by 1010h", {}}};
  return {};
}

Outcome store(const Call& call, const json&) {
  const auto begun = begin_save(call);
  if (begun) return status_of_storage(call.instance);
  control::Error error = begun.error();
  if (error.code == ErrorCode::Refused)
    error.message =
        "the parameters cannot be saved: " + call.instance.memory().parameters_text() + " (" + error.message + ")";
  return tl::unexpected{std::move(error)};
}

Outcome storage_status(const Call& call, const json&) {
  return status_of_storage(call.instance);
}

constexpr std::array<std::string_view, 2> kChoices{"factory", "stored"};

Outcome restore(const Call& call, const json& params) {
  const auto which = Arguments{params}.choice("which", kChoices);
  if (!which) return tl::unexpected{which.error()};
  device::Device& device = call.instance.device();
  if (!device.is_on()) return tl::unexpected{unit_is_off()};
  if (device.is_saving()) return refuse(ErrorCode::Busy, "parameters are being saved: try again");
  if (kChoices[*which] == "stored") {
    if (!call.instance.has_parameters())
      return refuse(ErrorCode::Refused,
                    "a device of this profile takes over what is stored when it is switched on, or reset by NMT");
    const auto done = command(call, kReset);
    return done ? Outcome{json::object()} : tl::unexpected{done.error()};
  }
  if (device.restore(call.now)) return refuse(ErrorCode::Refused, "not while the pulses of an axis are enabled");
  return json::object();
}

constexpr std::array kStorageHandlers{
    Handler{"store", &store},
    Handler{"store.status", &storage_status},
    Handler{"restore", &restore},
};

}  // namespace

std::span<const Handler> storage_handlers() noexcept {
  return kStorageHandlers;
}

}  // namespace axisd
