#include "gateway/units/reach.hpp"

#include "control/discovery/socket_files.hpp"
#include "control/discovery/trusted_server.hpp"

namespace gateway {

std::vector<std::string> SocketReach::places() const {
  if (!paths_.empty()) return paths_;
  std::vector<std::string> found;
  for (const control::SocketFile& file : control::socket_files()) found.push_back(file.path);
  return found;
}

tl::expected<os::Descriptor, std::string> SocketReach::connect(const std::string& path) {
  return control::connect_to(path);
}

}  // namespace gateway
