#pragma once

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include <gtest/gtest.h>
#include <sched.h>
#include <unistd.h>

namespace network {

/// Takes this process, which must have one thread, into a network of its own that has only lo: what is sent there
/// reaches nobody else. Needs root or user namespaces.
class OwnNetwork : public testing::Environment {
 public:
  void SetUp() override {
    const uid_t user = ::getuid();
    const int user_namespace = user == 0 ? 0 : CLONE_NEWUSER;
    if (::unshare(CLONE_NEWNET | user_namespace) != 0)
      throw std::system_error{errno, std::generic_category(), "a network namespace (needs root)"};
    if (user_namespace != 0) std::ofstream{"/proc/self/uid_map"} << "0 " << user << " 1";
    if (std::system("ip link set lo up") != 0) throw std::runtime_error{"ip link set lo up"};
  }
};

}  // namespace network
