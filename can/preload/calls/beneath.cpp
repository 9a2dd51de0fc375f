// What the parts of userbus/ in this library call. The linker (--wrap) turns their calls here, so that they reach
// the kernel's sockets and not the CAN sockets that this library makes of them.
#include "can/preload/next.hpp"
#include "can/preload/time/base/real.hpp"

using preload::next;
using preload::real;

extern "C" {

int __wrap_socket(int domain, int type, int protocol) {
  return next().socket(domain, type, protocol);
}

int __wrap_bind(int descriptor, const sockaddr* address, socklen_t length) {
  return next().bind(descriptor, address, length);
}

int __wrap_connect(int descriptor, const sockaddr* address, socklen_t length) {
  return next().connect(descriptor, address, length);
}

int __wrap_close(int descriptor) {
  return next().close(descriptor);
}

int __wrap_getsockopt(int descriptor, int level, int name, void* value, socklen_t* length) {
  return next().getsockopt(descriptor, level, name, value, length);
}

int __wrap_setsockopt(int descriptor, int level, int name, const void* value, socklen_t length) {
  return next().setsockopt(descriptor, level, name, value, length);
}

int __wrap_getsockname(int descriptor, sockaddr* address, socklen_t* length) {
  return next().getsockname(descriptor, address, length);
}

ssize_t __wrap_sendmsg(int descriptor, const msghdr* message, int flags) {
  return next().sendmsg(descriptor, message, flags);
}

ssize_t __wrap_recvmsg(int descriptor, msghdr* message, int flags) {
  return next().recvmsg(descriptor, message, flags);
}

int __wrap_poll(pollfd* descriptors, nfds_t count, int milliseconds) {
  return real().poll(descriptors, count, milliseconds);
}

pid_t __wrap_waitpid(pid_t process, int* status, int options) {
  return real().waitpid(process, status, options);
}

int __wrap_execve(const char* path, char* const* words, char* const* environment) {
  return real().execve(path, words, environment);
}

int __wrap_dup2(int from, int to) {
  return real().dup2(from, to);
}

int __wrap_close_range(unsigned first, unsigned last, int flags) {
  return real().close_range(first, last, flags);
}

}  // extern "C"
