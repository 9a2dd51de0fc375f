#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "gateway/base/error.hpp"

namespace gateway {
namespace {

std::string text_of(const char* path) {
  std::ifstream file{path};
  return {std::istreambuf_iterator<char>{file}, {}};
}

TEST(HttpPage, IsUpToDate) {
  const std::string made = text_of(ROUTES_PAGE);
  ASSERT_NE(made, "");

  EXPECT_NE(text_of(SOURCE_FOLDER "/docs/reference/http.md").find(": begin -->\n" + made + "<!-- "),
            std::string::npos)
      << "docs/reference/http.md differs from gateway/routes/: cmake --build BUILD --target update_generated";
}

TEST(Errors, HaveRowsInTheOrderOfTheirEnumerations) {
  for (std::size_t at = 0; at < kControlStatus.size(); ++at)
    EXPECT_EQ(kControlStatus[at].code, control::kErrorNames[at].code);
  EXPECT_EQ(refuse(Refused::SilentDaemon, "").code, "silent-daemon");
  EXPECT_EQ(refuse(Refused::BadRequest, "").code, "bad-request");
  EXPECT_EQ(kRefusals.size(), static_cast<std::size_t>(Refused::SilentDaemon) + 1);
}

TEST(Errors, AreToldAsTheControlSocketTellsThem) {
  const Error error = refused_by_daemon(control::ErrorCode::OutOfRange, "too much", {{"limits", {{"low", 0}}}});
  EXPECT_EQ(error.status, Status::UnprocessableContent);
  EXPECT_EQ(body_of(error), R"({"error":{"code":"out-of-range","limits":{"low":0},"message":"too much"}})"
                            "\n");
}

}  // namespace
}  // namespace gateway
