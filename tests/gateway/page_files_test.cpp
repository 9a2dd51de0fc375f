#include "gateway/page/page_files.hpp"

#include <fstream>

#include <gtest/gtest.h>

#include "gateway/page/page_answer.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace gateway {
namespace {

class Page : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder.path("web/assets/deeper"));
    write("index.html", "<!doctype html>");
    write("index.html.gz", "packed page");
    write("assets/index-1a2b.js", "let a = 1;");
    write("assets/index-1a2b.js.gz", "packed");
    write("assets/icon.svg", "<svg/>");
    write("assets/secret.sh", "exit 0");
    write("assets/deeper/other.js", "let b = 2;");
    write("session.html", "<!doctype html>");
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream{folder.path("web/" + name)} << text;
  }
  [[nodiscard]] PageFiles load() const { return PageFiles{folder.path("web")}; }

  fakes::TemporaryDirectory folder;
};

std::string header(const Response& response, std::string_view name) {
  for (const auto& [key, value] : response.headers)
    if (key == name) return value;
  return {};
}

Request request(std::vector<std::pair<std::string, std::string>> headers) {
  return {.verb = "GET", .headers = std::move(headers)};
}

TEST_F(Page, IsReadAtOnce) {
  const PageFiles page = load();
  std::filesystem::remove_all(folder.path("web"));
  ASSERT_NE(page.start(), nullptr);
  EXPECT_EQ(*page.start()->plain, "<!doctype html>");
  ASSERT_NE(page.asset("index-1a2b.js"), nullptr);
  EXPECT_EQ(*page.asset("index-1a2b.js")->gzip, "packed");
  EXPECT_EQ(page.asset("icon.svg")->gzip, nullptr);
  EXPECT_EQ(page.asset("icon.svg")->type, "image/svg+xml");
}

TEST_F(Page, HasNothingButItsFiles) {
  const PageFiles page = load();
  for (const char* const name : {"secret.sh", "deeper", "deeper/other.js", "other.js", "../session.html", "..", "",
                                 "index.html", "index-1a2b.js.gz", "%2e%2e/index.html"})
    EXPECT_EQ(page.asset(name), nullptr) << name;
}

TEST_F(Page, IsNoneWithoutItsStart) {
  std::filesystem::remove(folder.path("web/index.html"));
  const PageFiles page = load();
  EXPECT_EQ(page.start(), nullptr);
  EXPECT_EQ(page.asset("icon.svg"), nullptr);
  EXPECT_EQ(PageFiles{folder.path("nowhere")}.start(), nullptr);
  EXPECT_EQ(PageFiles{}.start(), nullptr);
}

TEST_F(Page, IsCompressedForWhoTakesIt) {
  const PageFiles page = load();
  const Response packed = page_answer(request({{"Accept-Encoding", "br, gzip"}}), *page.start(), Keep::Asks);
  EXPECT_EQ(packed.text(), "packed page");
  EXPECT_EQ(header(packed, "Content-Encoding"), "gzip");
  EXPECT_EQ(header(packed, "Vary"), "Accept-Encoding");
  EXPECT_EQ(packed.content_type, "text/html; charset=utf-8");
  const Response plain = page_answer(request({}), *page.start(), Keep::Asks);
  EXPECT_EQ(plain.text(), "<!doctype html>");
  EXPECT_EQ(header(plain, "Content-Encoding"), "");
  EXPECT_NE(header(plain, "ETag"), header(packed, "ETag"));
  const Response icon =
      page_answer(request({{"Accept-Encoding", "gzip"}}), *page.asset("icon.svg"), Keep::ForEver);
  EXPECT_EQ(icon.text(), "<svg/>");
}

TEST(AcceptEncoding, IsReadAsItIsMeant) {
  for (const char* const text : {"gzip", "gzip, deflate, br", "br;q=1.0, GZIP;q=0.5", " gzip ;q=0.01"})
    EXPECT_TRUE(takes_gzip(text)) << text;
  for (const char* const text : {"", "br", "identity", "gzip;q=0", "gzip; q=0.000, br", "x-gzip", ",,"})
    EXPECT_FALSE(takes_gzip(text)) << text;
}

TEST_F(Page, IsNotSentAgainToWhoHasIt) {
  const PageFiles page = load();
  const std::string tag = header(page_answer(request({}), *page.start(), Keep::Asks), "ETag");
  for (const std::string& known : {tag, "W/" + tag, "\"other\", " + tag, std::string{"*"}}) {
    const Response again = page_answer(request({{"If-None-Match", known}}), *page.start(), Keep::Asks);
    EXPECT_EQ(again.status, Status::NotModified) << known;
    EXPECT_EQ(again.text(), "");
    EXPECT_EQ(header(again, "ETag"), tag);
  }
  EXPECT_EQ(page_answer(request({{"If-None-Match", "\"other\""}}), *page.start(), Keep::Asks).status, Status::Ok);
}

TEST_F(Page, LoadsNothingFromElsewhereAndIsKeptAsItMayBe) {
  const PageFiles page = load();
  const Response start = page_answer(request({}), *page.start(), Keep::Asks);
  EXPECT_EQ(
      header(start, "Content-Security-Policy"),
      "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src 'self'; "
      "base-uri 'none'; form-action 'none'; frame-ancestors 'none'");
  EXPECT_EQ(header(start, "Cross-Origin-Opener-Policy"), "same-origin");
  EXPECT_EQ(header(start, "Cross-Origin-Resource-Policy"), "same-origin");
  EXPECT_EQ(header(start, "Cache-Control"), "no-cache");
  const Response script = page_answer(request({}), *page.asset("index-1a2b.js"), Keep::ForEver);
  EXPECT_EQ(header(script, "Cache-Control"), "public, max-age=31536000, immutable");
}

}  // namespace
}  // namespace gateway
