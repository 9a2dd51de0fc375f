#pragma once

#include <csignal>
#include <fstream>
#include <string>
#include <thread>

#include "tests/e2e/daemon_process.hpp"

namespace e2e {

/// Stops @p daemon by SIGSTOP, and waits until it stands: the signal alone returns earlier.
inline void suspend(DaemonProcess& daemon) {
  daemon.program().signal(SIGSTOP);
  const std::string path = "/proc/" + std::to_string(daemon.program().id()) + "/stat";
  const auto stands = [&path] {
    std::string text;
    std::ifstream stat{path};
    std::getline(stat, text);
    return text.find(") T ") != std::string::npos;
  };
  while (!stands()) std::this_thread::yield();
}

}  // namespace e2e
