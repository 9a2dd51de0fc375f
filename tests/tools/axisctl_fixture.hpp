#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/fakes/child_process.hpp"
#include "tests/fakes/control_server.hpp"
#include "tests/fakes/temporary_directory.hpp"

/// Answer without news.
inline constexpr const char* kDone = "{\"id\":1,\"result\":{}}\n";

/// Runs the built axisctl with a runtime directory of its own.
struct Axisctl : testing::Test {
  fakes::TemporaryDirectory folder;

  std::string socket() const { return folder.path("axisd-vcan0-2.sock"); }
  fakes::Finished run(std::vector<std::string> words) const {
    words.insert(words.begin(), AXISCTL);
    return fakes::run_program(words, {"RUNTIME_DIRECTORY=" + folder.path()});
  }
};

/// The daemon's line that brings @p result.
inline std::string answer(const nlohmann::json& result) {
  return nlohmann::json{{"id", 1}, {"result", result}}.dump() + "\n";
}
