#include "tests/e2e/candump_log.hpp"

#include <chrono>
#include <stdexcept>

#include "tests/e2e/test_bus.hpp"
#include "tests/fakes/child_process.hpp"

namespace e2e {
namespace {

bool cansend(const std::string& frame) {
  return fakes::run_program({CANSEND_PROGRAM, kTestInterface, frame}, bus_environment()).status == 0;
}

/// As candump -L ends its lines.
std::string line_of(const std::string& frame) {
  return std::string{' '} + kTestInterface + ' ' + frame + '\n';
}

bool is_error_frame(const std::string& frame) {
  constexpr std::size_t kDigits = 8;
  return frame.starts_with('2') && frame.find('#') == kDigits;
}

}  // namespace

// A candump that stands still for a while has room for what comes meanwhile: -r.
CandumpLog::CandumpLog() : candump_{{CANDUMP_PROGRAM, "-L", "-r", "1048576", kTestInterface}, bus_environment()} {
  // Frames before candump records are lost.
  constexpr std::chrono::milliseconds kBetweenProbes{20};
  const std::string probe = "7FF#00";
  const auto end = std::chrono::steady_clock::now() + kPatience;
  do {
    if (!cansend(probe))
      throw std::runtime_error{
          "cansend on vcan0; make the interface with scripts/vcan-setup.sh vcan0, or run the test in "
          "scripts/vcan-vm"};
    if (std::chrono::steady_clock::now() > end) throw std::runtime_error{"candump records nothing"};
  } while (!candump_.wait_for_output(probe, 0, kBetweenProbes));
}

testing::AssertionResult CandumpLog::send(const std::string& frame) {
  if (!cansend(frame)) return testing::AssertionFailure() << "cansend " << frame;
  return is_error_frame(frame) ? testing::AssertionSuccess() : shows({frame});
}

testing::AssertionResult CandumpLog::shows(std::initializer_list<std::string> frames) {
  for (const std::string& frame : frames) {
    const std::string line = line_of(frame);
    if (!candump_.wait_for_output(line, from_))
      return testing::AssertionFailure() << "expected " << frame << " in\n" << candump_.output().substr(from_);
    from_ = candump_.output().find(line, from_) + line.size();
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult CandumpLog::shows_none_of(std::initializer_list<std::string> identifiers) {
  const std::string log = candump_.output().substr(from_);
  for (const std::string& identifier : identifiers)
    if (log.find(std::string{' '} + kTestInterface + ' ' + identifier + '#') != std::string::npos)
      return testing::AssertionFailure() << "expected none of " << identifier << " in\n" << log;
  return testing::AssertionSuccess();
}

}  // namespace e2e
