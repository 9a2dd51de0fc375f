#include <csignal>
#include <cstdio>
#include <exception>

#include <sys/resource.h>

#include "farm/agent/program/options.hpp"
#include "farm/agent/program/program.hpp"
#include "os/missing_memory.hpp"

namespace {

namespace agent = farm::agent;

/// A descriptor a unit: as many as the system lets us have.
void allow_many_descriptors() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

int serve(const agent::Options& options) {
  allow_many_descriptors();
  const axisd::Log log{options.log_level, "axisd-agent"};
  agent::Program program{options, log};
  return program.run() ? agent::kDone : agent::kFailure;
}

int fail(const std::exception& error, int status) {
  std::fprintf(stderr, "axisd-agent: %s\n", error.what());
  return status;
}

}  // namespace

int main(int count, char** words) {
  os::end_if_memory_is_missing("axisd-agent", agent::kFailure);
  std::signal(SIGPIPE, SIG_IGN);  // a reader of the log that goes away
  try {
    const auto options = agent::parse_command_line(count, words);
    return options ? serve(*options) : agent::kDone;
  } catch (const agent::UsageError& error) {
    return fail(error, agent::kUsage);
  } catch (const std::exception& error) {
    return fail(error, agent::kFailure);
  }
}
