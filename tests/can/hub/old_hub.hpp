#pragma once

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <sys/socket.h>
#include <sys/un.h>

#include "can/userbus/protocol.hpp"
#include "os/descriptor.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace hub_test {

/// Serves one member as a hub of before there were faults, and messages of several frames: it answers the first
/// operations, whatever comes with them, and everything else with EINVAL.
class OldHub {
 public:
  OldHub() {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strcpy(address.sun_path, path().c_str());
    if (bind(listener_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
        listen(listener_.get(), 1) != 0)
      throw std::runtime_error{"no socket for an old hub"};
    thread_ = std::thread{[this] { serve(); }};
  }
  OldHub(const OldHub&) = delete;
  OldHub& operator=(const OldHub&) = delete;
  ~OldHub() { finish(); }

  [[nodiscard]] std::string path() const { return folder_.path("bus"); }
  /// Returns when the member has gone.
  void finish() {
    if (thread_.joinable()) thread_.join();
  }
  /// Sizes of the messages with frames that it has sent (bytes); after finish().
  [[nodiscard]] const std::vector<std::size_t>& sizes() const { return sizes_; }

 private:
  void serve() {
    const os::Descriptor member{accept(listener_.get(), nullptr, nullptr)};
    userbus::Request request{};
    std::array<char, userbus::kLongestMessage> payload{};
    std::array parts{iovec{&request, sizeof request}, iovec{payload.data(), payload.size()}};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
    for (;;) {
      msghdr message{};
      message.msg_iov = parts.data();
      message.msg_iovlen = parts.size();
      message.msg_control = control.data();
      message.msg_controllen = control.size();
      const ssize_t size = recvmsg(member.get(), &message, 0);
      if (size <= 0) return;
      if (const cmsghdr* const passed = CMSG_FIRSTHDR(&message); passed != nullptr)
        answer(request.operation, *passed);
      else
        sizes_.push_back(static_cast<std::size_t>(size));
    }
  }

  static void answer(userbus::Operation operation, const cmsghdr& passed) {
    int answering = -1;
    std::memcpy(&answering, CMSG_DATA(&passed), sizeof answering);
    const os::Descriptor socket{answering};
    constexpr int kIndex = 1001;
    const bool is_known = operation <= userbus::Operation::Interfaces;
    const userbus::Reply reply{.error = is_known ? 0 : EINVAL,
                               .value = operation == userbus::Operation::InterfaceIndex ? kIndex : 0,
                               .size = 0};
    send(socket.get(), &reply, sizeof reply, MSG_NOSIGNAL);
  }

  fakes::TemporaryDirectory folder_;
  os::Descriptor listener_{socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0)};
  std::vector<std::size_t> sizes_;
  std::thread thread_;
};

}  // namespace hub_test
