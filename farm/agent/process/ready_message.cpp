#include "farm/agent/process/ready_message.hpp"

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

#include <sys/epoll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "control/socket_name.hpp"

namespace farm::agent {
namespace {

constexpr std::string_view kReady = "READY=1";

os::Descriptor listen_at(const std::string& path) {
  const auto address = control::socket_address(path);
  if (!address) return {};
  ::unlink(path.c_str());
  os::Descriptor socket{::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)};
  if (!socket || ::bind(socket.get(), reinterpret_cast<const sockaddr*>(&*address), sizeof *address) != 0)
    return {};
  return socket;
}

}  // namespace

ReadyMessage::ReadyMessage(axisd::ServiceEvents& events, std::string path, std::function<void()> on_ready)
    : path_{std::move(path)}, on_ready_{std::move(on_ready)}, socket_{listen_at(path_)} {
  if (!socket_) return;
  source_ = events.watch(
      socket_.get(), EPOLLIN,
      [](sd_event_source*, int, std::uint32_t, void* self) noexcept {
        static_cast<ReadyMessage*>(self)->take();
        return 0;
      },
      this);
}

ReadyMessage::~ReadyMessage() {
  if (socket_) ::unlink(path_.c_str());
}

void ReadyMessage::take() {
  std::array<char, 1024> buffer{};
  const ssize_t size = ::recv(socket_.get(), buffer.data(), buffer.size(), 0);
  if (size < 0 || !std::string_view{buffer.data(), static_cast<std::size_t>(size)}.starts_with(kReady)) return;
  source_.reset();
  const std::function<void()> tell = std::move(on_ready_);
  tell();
}

}  // namespace farm::agent
