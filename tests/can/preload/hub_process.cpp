#include "tests/can/preload/hub_process.hpp"

#include <array>
#include <cstdlib>
#include <stdexcept>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace preload_test {

namespace {

/// Reads from @p descriptor until "ready" has come.
bool wait_until_ready(int descriptor) {
  std::string text;
  std::array<char, 256> part{};
  while (text.find("ready") == std::string::npos) {
    const ssize_t size = ::read(descriptor, part.data(), part.size());
    if (size <= 0) return false;
    text.append(part.data(), static_cast<std::size_t>(size));
  }
  return true;
}

}  // namespace

HubProcess::HubProcess() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error{"pipe2"};
  process_ = ::fork();
  if (process_ == 0) {
    ::dup2(ends[1], STDERR_FILENO);
    ::unsetenv("LD_PRELOAD");
    ::execl(CANHUB, CANHUB, "--path", std::getenv("CAN_BUS"), nullptr);
    ::_exit(127);
  }
  ::close(ends[1]);
  messages_ = ends[0];
  if (!wait_until_ready(messages_)) throw std::runtime_error{"canhub does not get ready"};
}

HubProcess::~HubProcess() {
  if (process_ > 0) kill();
  ::close(messages_);
}

void HubProcess::kill() {
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
  process_ = -1;
}

}  // namespace preload_test
