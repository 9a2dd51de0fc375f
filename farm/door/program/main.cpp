#include <csignal>
#include <cstdio>
#include <exception>

#include <sys/resource.h>

#include "farm/door/program/options.hpp"
#include "farm/door/program/program.hpp"
#include "os/missing_memory.hpp"

namespace {

/// A descriptor a daemon, and one for whoever is told something: as many as the system lets us have.
void allow_many_descriptors() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

int serve(const farm::Options& options) {
  allow_many_descriptors();
  const axisd::Log log{options.log_level, "axisd-nats"};
  farm::Program program{options, log};
  program.run();
  return farm::kDone;
}

int fail(const std::exception& error, int status) {
  std::fprintf(stderr, "axisd-nats: %s\n", error.what());
  return status;
}

}  // namespace

int main(int count, char** words) {
  os::end_if_memory_is_missing("axisd-nats", farm::kFailure);
  std::signal(SIGPIPE, SIG_IGN);  // a reader of the log that goes away
  try {
    const auto options = farm::parse_command_line(count, words);
    return options ? serve(*options) : farm::kDone;
  } catch (const farm::UsageError& error) {
    return fail(error, farm::kUsage);
  } catch (const std::exception& error) {
    return fail(error, farm::kFailure);
  }
}
