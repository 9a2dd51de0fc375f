#include "tools/axisctl/socket_choice.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "daemon/control_protocol.hpp"

namespace axisctl {

namespace {

std::vector<std::string> present_sockets() {
  std::vector<std::string> paths;
  std::error_code ignored;  // a folder that cannot be read holds no socket for us
  for (std::filesystem::directory_iterator entry{control::runtime_directory(), ignored}, end; entry != end;
       entry.increment(ignored)) {
    if (ignored) break;
    if (control::is_socket_name(entry->path().filename().string()) && entry->is_socket(ignored))
      paths.push_back(entry->path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace

tl::expected<std::string, std::vector<std::string>> choose_socket(const Address& address) {
  if (address.socket) return *address.socket;
  if (!address.label && !address.node) {
    std::vector<std::string> present = present_sockets();
    if (present.size() == 1) return present.front();
    if (present.size() > 1) return tl::unexpected{std::move(present)};
  }
  return control::default_socket_path(address.label.value_or(std::string{control::kDefaultInterface}),
                                      address.node.value_or(control::kDefaultNode));
}

}  // namespace axisctl
