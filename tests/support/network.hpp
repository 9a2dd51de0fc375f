#pragma once

#include <cstdlib>
#include <stdexcept>
#include <string>

#include <poll.h>

namespace network {

/// Runs `ip ARGUMENTS`; throws if it fails, for nothing after it could be believed.
inline void ip(const std::string& arguments) {
  if (std::system(("ip " + arguments).c_str()) != 0) throw std::runtime_error{"ip " + arguments};
}

/// A virtual CAN interface of its own for one test.
class VirtualCan {
 public:
  explicit VirtualCan(std::string name) : name_{std::move(name)} { create(); }
  VirtualCan(const VirtualCan&) = delete;
  VirtualCan& operator=(const VirtualCan&) = delete;
  ~VirtualCan() {
    if (present_) std::system(("ip link del " + name_).c_str());
  }

  void create() {
    ip("link add dev " + name_ + " type vcan");
    present_ = true;
    up();
  }
  void remove() {
    ip("link del " + name_);
    present_ = false;
  }
  void up() const { ip("link set " + name_ + " up"); }
  void down() const { ip("link set " + name_ + " down"); }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
  bool present_ = false;
};

/// Waits until @p descriptor has something to say; false if it stays silent for ten seconds.
inline bool readable(int descriptor) {
  pollfd wanted{descriptor, POLLIN, 0};
  return ::poll(&wanted, 1, 10'000) == 1;
}

}  // namespace network
