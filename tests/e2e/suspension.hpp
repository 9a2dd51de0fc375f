#pragma once

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "tests/e2e/daemon_process.hpp"

namespace e2e {

/// Stops @p daemon by SIGSTOP, and waits until all its threads stand: the signal alone returns earlier.
inline void suspend(DaemonProcess& daemon) {
  daemon.program().signal(SIGSTOP);
  const std::filesystem::path tasks = "/proc/" + std::to_string(daemon.program().id()) + "/task";
  const auto stands = [](const std::filesystem::directory_entry& task) {
    std::string text;
    std::ifstream stat{task.path() / "stat"};
    std::getline(stat, text);
    return text.find(") T ") != std::string::npos;
  };
  const auto all_stand = [&] { return std::ranges::all_of(std::filesystem::directory_iterator{tasks}, stands); };
  while (!all_stand()) std::this_thread::yield();
}

}  // namespace e2e
