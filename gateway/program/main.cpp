#include <csignal>
#include <cstdio>
#include <exception>

#include <sys/resource.h>

#include "gateway/program/options.hpp"
#include "gateway/program/program.hpp"
#include "os/missing_memory.hpp"

namespace {

/// A descriptor a client: as many as the system lets us have.
void allow_many_descriptors() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

int serve(const gateway::Options& options) {
  allow_many_descriptors();
  const axisd::Log log{options.log_level, "axisd-http"};
  gateway::Program program{options, log};
  program.run();
  return gateway::kDone;
}

int fail(const std::exception& error, int status) {
  std::fprintf(stderr, "axisd-http: %s\n", error.what());
  return status;
}

}  // namespace

int main(int count, char** words) {
  os::end_if_memory_is_missing("axisd-http", gateway::kFailure);
  std::signal(SIGPIPE, SIG_IGN);  // a reader of the log that goes away
  try {
    const auto options = gateway::parse_command_line(count, words);
    return options ? serve(*options) : gateway::kDone;
  } catch (const gateway::UsageError& error) {
    return fail(error, gateway::kUsage);
  } catch (const std::exception& error) {
    return fail(error, gateway::kFailure);
  }
}
