#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <system_error>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "can/hub/path/path_owner.hpp"
#include "can/hub/server.hpp"
#include "os/missing_memory.hpp"
#include "tools/canhub/faults.hpp"
#include "tools/canhub/neighbours.hpp"
#include "tools/canhub/options.hpp"
#include "tools/canhub/signals.hpp"
#include "tools/canhub/status.hpp"

namespace {

using userbus::StartStatus;

int status_of(StartStatus status) noexcept {
  return static_cast<int>(status);
}

int complain(std::string_view text, StartStatus status) {
  std::cerr << "canhub: " << text << '\n';
  return status_of(status);
}

/// A descriptor a member, and members hold theirs: as many as the system lets us have.
void raise_descriptor_limit() noexcept {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);
}

/// Serves until a signal comes, or as long as the hub is wanted.
void serve(hub::PathOwner& owner, const canhub::Options& options) {
  constexpr userbus::TimeWish kReal{userbus::TimeMode::Real, 1};
  hub::Server server{
      owner.listener(),
      {.bit_rate = options.bit_rate.value_or(0),
       .on_demand = options.on_demand,
       .time = options.time.value_or(kReal),
       .turns = {.notice = [](std::string_view line) { std::cerr << "canhub: " << line << std::endl; }}}};
  const canhub::Signals signals{server};
  const canhub::Neighbours neighbours{server, options};
  canhub::load_faults(server, options);
  if (!options.on_demand) std::cerr << "canhub: ready, serving " << options.path.text << std::endl;
  server.run();
  owner.release();  // before the members are told, so that they do not come back here
}

/// Nothing of whoever started the hub shall be held by it: terminal, session, folder, pipes.
void leave_caller() noexcept {
  setsid();
  const int null = open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(null, standard);
  if (null > STDERR_FILENO) close(null);
  [[maybe_unused]] const int ignored = chdir("/");
}

/// The caller goes on as soon as the path listens; a child serves.
int serve_on_demand(hub::PathOwner& owner, const canhub::Options& options) {
  const pid_t child = fork();
  if (child < 0) throw std::system_error{errno, std::generic_category(), "fork"};
  if (child > 0) {
    owner.sign(child);
    std::_Exit(status_of(StartStatus::Served));  // the path is the child's: nothing is cleaned up here
  }
  leave_caller();
  serve(owner, options);
  return status_of(StartStatus::Served);
}

int run(const canhub::Options& options) {
  if (options.status)
    return canhub::print_status(options.path, std::cout, std::cerr) ? EXIT_SUCCESS : EXIT_FAILURE;
  if (options.is_about_faults()) return canhub::command_faults(options, std::cout, std::cerr);
  raise_descriptor_limit();
  std::signal(SIGPIPE, SIG_IGN);  // a reader of standard error that goes does not end the bus
  auto owner = hub::PathOwner::take(options.path, {.bit_rate = options.bit_rate, .time = options.time});
  if (!owner) {
    const hub::Refusal& refusal = owner.error();
    if (refusal.status == StartStatus::Served && options.on_demand) return status_of(StartStatus::Served);
    return complain(refusal.text, options.on_demand ? refusal.status : StartStatus::Failed);
  }
  if (options.on_demand) return serve_on_demand(*owner, options);
  owner->sign(getpid());
  serve(*owner, options);
  return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
  os::end_if_memory_is_missing("canhub", static_cast<int>(StartStatus::Failed));
  try {
    const auto options = canhub::parse_command_line(argc, argv);
    return options ? run(*options) : EXIT_SUCCESS;
  } catch (const canhub::UsageError& error) {
    return complain(error.what(), StartStatus::Usage);
  } catch (const std::exception& error) {
    return complain(error.what(), StartStatus::Failed);
  }
}
