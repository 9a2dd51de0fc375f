#include "tests/farm/link/link_fixture.hpp"

#include <csignal>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include <net/if.h>
#include <poll.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "os/descriptor.hpp"

namespace farm {

namespace {

void require(bool is_fine, const char* what) {
  if (!is_fine) throw std::system_error{errno, std::generic_category(), what};
}

/// Takes this process into a network that has only lo, once.
void enter_own_network() {
  static bool is_in = false;
  if (std::exchange(is_in, true)) return;
  require(::unshare(::geteuid() == 0 ? CLONE_NEWNET : CLONE_NEWUSER | CLONE_NEWNET) == 0, "unshare");
  const os::Descriptor socket{::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)};
  ifreq lo{};
  std::strcpy(lo.ifr_name, "lo");
  lo.ifr_flags = IFF_UP;
  require(::ioctl(socket.get(), SIOCSIFFLAGS, &lo) == 0, "lo");
}

}  // namespace

ServerProcess::ServerProcess() {
  enter_own_network();
  std::ofstream{folder_.path("server.conf")}
      << "listen: 127.0.0.1:4222\njetstream { store_dir: " << folder_.path("store") << " }\n";
  start();
}

ServerProcess::~ServerProcess() {
  kill();
}

nats::Server ServerProcess::address() const {
  return {"nats://127.0.0.1:4222", {}, {}, {}, {}};
}

void ServerProcess::start() {
  const std::string configuration = folder_.path("server.conf");
  process_ = ::fork();
  require(process_ >= 0, "fork");
  if (process_ > 0) return;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::execlp("nats-server", "nats-server", "-c", configuration.c_str(), "-l", "/dev/null", nullptr);
  ::_exit(127);
}

void ServerProcess::kill() {
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
  process_ = -1;
}

void ServerProcess::stop() const {
  ::kill(process_, SIGSTOP);
  ::waitpid(process_, nullptr, WUNTRACED);
}

void ServerProcess::go_on() const {
  ::kill(process_, SIGCONT);
}

void LinkTest::wait_until(const std::function<bool()>& is_done) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{20};
  while (!is_done()) {
    pollfd ready{events_.descriptor(), POLLIN, 0};
    ::poll(&ready, 1, 100);
    while (events_.dispatch()) {
    }
    if (std::chrono::steady_clock::now() > end) throw std::runtime_error{"waited in vain"};
  }
}

void LinkTest::wait_for(std::chrono::milliseconds time) {
  const auto end = std::chrono::steady_clock::now() + time;
  wait_until([end] { return std::chrono::steady_clock::now() >= end; });
}

}  // namespace farm
