#include "daemon/fleet/served_unit.hpp"

#include <utility>

namespace axisd {

ServedUnit::ServedUnit(const Configuration& configuration, const std::filesystem::path& state_root, Log log,
                       UnitLoop& loop, InstanceListener& listener)
    : configuration_{configuration},
      name_{name_of(configuration)},
      log_{std::move(log)},
      loop_{loop},
      listener_{listener},
      lock_{state_root / folder_of(configuration), configuration.address, station_of(configuration)} {
  switch_on();
}

void ServedUnit::switch_on() {
  auto instance = std::make_unique<Instance>(configuration_, lock_.directory(), log_, listener_);
  if (configuration_.node_id == kAddressSwitchOff)
    lock_.serve(configuration_.address, instance->device().node_id());
  instance->load();
  instance_ = std::move(instance);
  is_on_ = true;
}

void ServedUnit::switch_off() noexcept {
  if (instance_ == nullptr) return;
  is_on_ = false;
  instance_->power_off();
  instance_.reset();
  log_.info("power-off");
}

}  // namespace axisd
