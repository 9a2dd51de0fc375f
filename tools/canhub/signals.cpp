#include "tools/canhub/signals.hpp"

#include <cerrno>
#include <csignal>
#include <system_error>

#include <sys/signalfd.h>

namespace canhub {

namespace {

int open_signals() {
  sigset_t ends;
  sigemptyset(&ends);
  sigaddset(&ends, SIGTERM);
  sigaddset(&ends, SIGINT);
  sigprocmask(SIG_BLOCK, &ends, nullptr);
  const int descriptor = signalfd(-1, &ends, SFD_NONBLOCK | SFD_CLOEXEC);
  if (descriptor < 0) throw std::system_error{errno, std::generic_category(), "signalfd"};
  return descriptor;
}

}  // namespace

Signals::Signals(hub::Server& server) : server_{server}, descriptor_{open_signals()} {
  server_.add(*this);
}

Signals::~Signals() {
  server_.remove(*this);
}

void Signals::on_readable(canopen::TimePoint) noexcept {
  server_.stop();
}

}  // namespace canhub
