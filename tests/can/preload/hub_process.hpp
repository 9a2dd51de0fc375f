#pragma once

#include <string>

#include <sys/types.h>

namespace preload_test {

/// A hub that serves the bus of this process ($CAN_BUS), and that can be killed.
class HubProcess {
 public:
  /// Returns when the hub is ready. Throws if it does not become so.
  HubProcess();
  HubProcess(const HubProcess&) = delete;
  HubProcess& operator=(const HubProcess&) = delete;
  ~HubProcess();

  /// Ends it without a chance to say so, and waits for its end.
  void kill();

 private:
  pid_t process_ = -1;
  int messages_ = -1;  // what it says on standard error
};

}  // namespace preload_test
