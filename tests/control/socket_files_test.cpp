#include "control/discovery/socket_files.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include "control/socket_name.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace control {
namespace {

/// A socket at @p path, which has a file.
void make_socket(const std::string& path) {
  std::filesystem::create_directories(std::filesystem::path{path}.parent_path());
  const auto address = socket_address(path);
  ASSERT_TRUE(address);
  const int descriptor = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  EXPECT_EQ(::bind(descriptor, reinterpret_cast<const sockaddr*>(&*address), sizeof *address), 0);
  ::close(descriptor);
}

TEST(SocketFiles, AreFoundWhereUsersAndTheirAgentsHaveThem) {
  const fakes::TemporaryDirectory folder;
  ::setenv("XDG_RUNTIME_DIR", folder.path().c_str(), 1);
  ::unsetenv("RUNTIME_DIRECTORY");
  const std::string own = folder.path("axisd-vcan0-5.sock");
  const std::string of_agent = folder.path("axisd/agent/axisd-line1-5.sock");
  make_socket(own);
  make_socket(of_agent);

  const auto files = socket_files();

  EXPECT_EQ(std::ranges::count(files, own, &SocketFile::path), 1);
  const auto found = std::ranges::find(files, of_agent, &SocketFile::path);
  ASSERT_NE(found, files.end());
  EXPECT_EQ(found->name->label, "line1");
}

}  // namespace
}  // namespace control
