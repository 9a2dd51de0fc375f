#pragma once

#include <functional>
#include <map>
#include <string>

#include "farm/agent/unit/unit_folder.hpp"
#include "os/descriptor.hpp"
#include "service/service_events.hpp"

namespace farm::agent {

/// Sees that units save something, by their folders.
class SavedFiles {
 public:
  using OnSaved = std::function<void(const UnitName& unit)>;

  /// @p on_saved is told of every unit of watch() whose parameters were replaced. @p events and @p folders outlive
  /// this. Throws std::system_error if the kernel gives no descriptor.
  SavedFiles(axisd::ServiceEvents& events, const Folders& folders, OnSaved on_saved);

  /// From now on; the folder of @p unit is there. The error is one line.
  [[nodiscard]] tl::expected<void, std::string> watch(const UnitName& unit);
  void leave(const UnitName& unit);

 private:
  void take();
  void tell_of(int watch, std::string_view file);

  const Folders& folders_;
  OnSaved on_saved_;
  os::Descriptor watches_;  ///< inotify
  std::map<int, UnitName> units_;
  axisd::EventSource source_;
};

}  // namespace farm::agent
