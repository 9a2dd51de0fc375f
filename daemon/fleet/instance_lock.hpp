#pragma once

#include <filesystem>
#include <string>

#include "can/port/address.hpp"
#include "daemon/base/instance_error.hpp"
#include "os/descriptor.hpp"

namespace axisd {

/// Where the state of all instances lies: @p given, else $STATE_DIRECTORY, else
/// ${XDG_STATE_HOME:-~/.local/state}/axisd.
std::filesystem::path state_root(const std::string& given);

/// Makes this process the only one that serves a node on a bus, for as long as it lives.
///
/// Two locks: a folder guards the files in it, and a name in the abstract socket space, which belongs to the same
/// network namespace as an interface of the kernel, guards the node against an instance that keeps its state
/// elsewhere. The name has bus::label() and station_of() the unit, whatever the bus is called; where the station
/// is address switch 0, the node that p8620 names is guarded too.
class InstanceLock {
 public:
  /// Creates @p directory, the folder for this instance's files, and takes both locks; throws InstanceError.
  InstanceLock(std::filesystem::path directory, const bus::Address& address, const std::string& station);

  /// Takes the lock on the node that the unit serves where that is not @p station of the constructor, which was
  /// the address switch; throws InstanceError.
  void serve(const bus::Address& address, int node_id);

  /// The folder for this instance's files.
  const std::filesystem::path& directory() const noexcept { return directory_; }

 private:
  std::filesystem::path directory_;
  os::Descriptor folder_;
  os::Descriptor name_;
  os::Descriptor served_name_;
};

}  // namespace axisd
