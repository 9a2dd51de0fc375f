#include "can/hub/loop/closer.hpp"

#include <csignal>
#include <exception>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace hub {

namespace {

/// The option @p name of a socket; -1 if there is none.
int option_of(int descriptor, int name) noexcept {
  int value = -1;
  socklen_t size = sizeof value;
  return getsockopt(descriptor, SOL_SOCKET, name, &value, &size) == 0 ? value : -1;
}

void close_all(const os::Descriptor& numbers) noexcept {
  int descriptor = -1;
  while (read(numbers.get(), &descriptor, sizeof descriptor) == sizeof descriptor) ::close(descriptor);
}

bool begin_thread(os::Descriptor numbers) noexcept {
  try {
    std::thread{[own = std::move(numbers)] { close_all(own); }}.detach();
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

bool Closer::start() noexcept {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return false;
  os::Descriptor from{ends[0]};
  os::Descriptor to{ends[1]};
  if (fcntl(to.get(), F_SETFL, O_NONBLOCK) != 0) return false;
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);  // signals are for the loop
  const bool started = begin_thread(std::move(from));
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (started) to_thread_ = std::move(to);
  return started;
}

void Closer::close(int descriptor) noexcept {
  if (!to_thread_ && !start()) return;
  [[maybe_unused]] const ssize_t written = write(to_thread_.get(), &descriptor, sizeof descriptor);
}

bool is_reply_socket(int descriptor) noexcept {
  if (option_of(descriptor, SO_DOMAIN) != AF_UNIX || option_of(descriptor, SO_TYPE) != SOCK_SEQPACKET ||
      option_of(descriptor, SO_ACCEPTCONN) != 0)
    return false;
  shutdown(descriptor, SHUT_RD);  // from now on nothing can come into it
  char first = 0;
  return recv(descriptor, &first, sizeof first, MSG_PEEK | MSG_DONTWAIT) <= 0;
}

}  // namespace hub
