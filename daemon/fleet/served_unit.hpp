#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "daemon/configuration/configuration.hpp"
#include "daemon/fleet/instance_lock.hpp"
#include "daemon/instance/instance.hpp"
#include "daemon/loop/unit_loop.hpp"
#include "service/log.hpp"

namespace axisd {

/// A unit of this program: what keeps others from its node for as long as the program lives, the loop that runs
/// it, and, while it is switched on, the instance. It belongs to the thread of the fleet, the instance to that of
/// its loop.
class ServedUnit {
 public:
  /// Switched on, with the state below @p state_root; the other arguments outlive this. Throws InstanceError,
  /// bus::OpenError or std::system_error.
  ServedUnit(const Configuration& configuration, const std::filesystem::path& state_root, Log log, UnitLoop& loop,
             InstanceListener& listener);

  const std::string& name() const noexcept { return name_; }
  const Configuration& configuration() const noexcept { return configuration_; }
  UnitLoop& loop() const noexcept { return loop_; }
  /// nullptr while the unit is switched off, or about to be.
  Instance* instance() const noexcept { return is_on_ ? instance_.get() : nullptr; }
  /// Whether it can be switched on.
  bool is_off() const noexcept { return instance_ == nullptr; }

  /// Power-on of a unit that is off; whoever calls adds the instance to the loop. Throws as the constructor does.
  void switch_on();
  /// Nobody else shall ask anything of the instance, which its loop is about to run no longer.
  Instance& begin_to_switch_off() noexcept { return is_on_ = false, *instance_; }
  /// Power-off of a unit that its loop runs no longer: what survives is on the disk when this returns.
  void switch_off() noexcept;

 private:
  const Configuration& configuration_;
  std::string name_;
  Log log_;
  UnitLoop& loop_;
  InstanceListener& listener_;
  InstanceLock lock_;
  std::unique_ptr<Instance> instance_;
  bool is_on_ = false;
};

}  // namespace axisd
