#include "tools/axisctl/socket_choice.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <sys/socket.h>

#include "control/socket_name.hpp"
#include "os/descriptor.hpp"

namespace axisctl {

namespace {

bool fits(const Address& address, const control::SocketName& name) {
  return address.label.value_or(std::string{name.label}) == name.label &&
         address.node.value_or(name.node) == name.node;
}

/// The sockets in the runtime folder that @p address can mean.
std::vector<std::string> present_sockets(const Address& address) {
  std::vector<std::string> paths;
  std::error_code ignored;  // a folder that cannot be read holds no socket for us
  for (std::filesystem::directory_iterator entry{control::runtime_directory(), ignored}, end; entry != end;
       entry.increment(ignored)) {
    if (ignored) break;
    const std::string file = entry->path().filename().string();
    const auto name = control::parse_socket_name(file);
    if (name && fits(address, *name) && entry->is_socket(ignored)) paths.push_back(entry->path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// Whether nobody listens at @p path any more. A socket of another type is refused before the daemon notices.
bool is_left_behind(const std::string& path) {
  const auto address = control::socket_address(path);
  const os::Descriptor socket{::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)};
  if (!address || !socket) return false;
  return ::connect(socket.get(), reinterpret_cast<const sockaddr*>(&*address), sizeof *address) != 0 &&
         errno == ECONNREFUSED;
}

std::string text_of(const Address& address) {
  if (!address.label) return fmt::format("with node-ID {}", *address.node);
  return fmt::format("on {}", *address.label);
}

}  // namespace

tl::expected<std::string, NoSocket> choose_socket(const Address& address) {
  if (address.socket) return *address.socket;
  if (address.label && address.node) return control::default_socket_path(*address.label, *address.node);
  std::vector<std::string> present = present_sockets(address);
  if (present.size() > 1) std::erase_if(present, is_left_behind);
  if (present.size() == 1) return present.front();
  if (present.size() > 1)
    return tl::unexpected{
        NoSocket{fmt::format("several daemons run; choose one with --socket, or --interface and --node-id:\n  {}",
                             fmt::join(present, "\n  ")),
                 true}};
  if (address.label || address.node)
    return tl::unexpected{NoSocket{fmt::format("no daemon {} runs: it would have its control socket in {}",
                                               text_of(address), control::runtime_directory())}};
  return control::default_socket_path(control::kDefaultInterface, control::kDefaultNode);
}

}  // namespace axisctl
