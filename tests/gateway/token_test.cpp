#include "gateway/security/token.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/fakes/temporary_directory.hpp"

namespace gateway {
namespace {

class TokenTest : public testing::Test {
 protected:
  std::string path_of(const std::string& text, mode_t mode = 0600) {
    const std::string path = folder.path("token");
    std::ofstream{path} << text;
    ::chmod(path.c_str(), mode);
    return path;
  }
  std::string refusal_of(const std::string& path) {
    const auto token = load_token(path);
    return token ? "taken" : token.error();
  }

  fakes::TemporaryDirectory folder;
};

TEST_F(TokenTest, IsMadeForItsOwnerAloneAndStays) {
  const std::string path = folder.path("axisd-http/token");
  const auto token = load_token(path);

  ASSERT_TRUE(token) << token.error();
  EXPECT_EQ(token->size(), 64U);
  struct stat status {};
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & ALLPERMS, 0600U);
  EXPECT_EQ(load_token(path), token);
  EXPECT_NE(load_token(folder.path("other")), token);
  EXPECT_FALSE(std::filesystem::exists(path + ".new"));
}

TEST_F(TokenTest, OfAPersonIsTaken) {
  EXPECT_EQ(load_token(path_of("a-token_of-someone-0123456789ABCDEF\n")), "a-token_of-someone-0123456789ABCDEF");
}

TEST_F(TokenTest, ThatOthersMayReadIsRefused) {
  const std::string path = path_of("0123456789abcdef0123456789abcdef", 0644);
  EXPECT_EQ(refusal_of(path), path + ": others may read or write the token (mode 0644, expected 0600)");
}

TEST_F(TokenTest, ThatIsNoneIsRefused) {
  for (const char* const text :
       {"", "short", "0123456789abcdef 0123456789abcdef", "0123456789abcdef\n0123456789abcdef"}) {
    const std::string path = path_of(text);
    EXPECT_EQ(refusal_of(path), path + ": is no token: expected at least 32 letters, digits, - and _") << text;
  }
}

TEST_F(TokenTest, ThatCannotBeReadOrMadeIsRefused) {
  EXPECT_EQ(refusal_of(folder.path()), folder.path() + ": cannot be read: Is a directory");
  const std::string below = path_of("x") + "/token";
  EXPECT_NE(refusal_of(below), "taken");
}

}  // namespace
}  // namespace gateway
