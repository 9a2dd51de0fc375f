#include "control/discovery/server_trust.hpp"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

namespace control {

bool is_trusted_server(uid_t server, uid_t self, const struct stat& folder) noexcept {
  const bool is_its_own_folder =
      S_ISDIR(folder.st_mode) && folder.st_uid == server && (folder.st_mode & (S_IWGRP | S_IWOTH)) == 0;
  return server == self || server == 0 || is_its_own_folder;
}

tl::expected<void, std::string> check_server(int socket, const std::string& path) {
  ucred peer{};
  socklen_t size = sizeof peer;
  if (::getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &peer, &size) != 0)
    return tl::unexpected{fmt::format("{}: {}", path, std::generic_category().message(errno))};
  const std::filesystem::path parent = std::filesystem::path{path}.parent_path();
  struct stat folder {};
  if (::stat(parent.empty() ? "." : parent.c_str(), &folder) != 0) folder = {};
  if (is_trusted_server(peer.uid, ::geteuid(), folder)) return {};
  return tl::unexpected{fmt::format(
      "{}: is served by user {}, and others than that user may put sockets there: it is not told anything", path,
      peer.uid)};
}

}  // namespace control
