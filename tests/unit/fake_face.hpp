#pragma once

#include <functional>
#include <string>
#include <vector>

#include "unit/runner.hpp"

namespace unit {

/// A face that notes what it is told and does before a cycle what the test says.
struct FakeFace final : Face {
  void bring() noexcept override {
    ++brought;
    if (before_cycle) before_cycle();
  }
  AxisMask waiting() const noexcept override { return waits_for; }
  void show() noexcept override { note("show"); }
  void on_cycles_over() noexcept override { note("cycles over"); }
  void show_messages(bool changed) noexcept override {
    if (changed) note("messages");
  }
  void adopt(const Replacement& replacement) noexcept override {
    note("adopt");
    adopted.push_back(replacement);
  }
  void resume(const Replacement&) noexcept override { note("resume"); }
  bool restart_unit() noexcept override { return restarts_itself && (note("restart"), true); }
  void on_stored(bool kept) noexcept override { note(kept ? "kept" : "lost"); }
  bool follow_up() noexcept override {
    if (work == 0) return false;
    --work;
    note("work");
    return true;
  }

  void note(const char* what) noexcept { told.emplace_back(what); }
  /// What it was told since the last call.
  std::vector<std::string> take() { return std::exchange(told, {}); }

  int brought = 0;                     ///< cycles that it has brought something to
  int work = 0;                        ///< pieces that wait for an answer to be out
  bool restarts_itself = false;        ///< its bus starts anew with the unit
  AxisMask waits_for = 0;              ///< axes
  std::function<void()> before_cycle;  ///< the test's
  std::vector<Replacement> adopted;    ///< all that it was told of
  std::vector<std::string> told;
};

}  // namespace unit
