#include "farm/storage/object_meta.hpp"
#include "tests/farm/link/link_fixture.hpp"

namespace farm {
namespace {

using namespace std::chrono_literals;

using Content = std::optional<std::string>;

class ObjectTest : public LinkTest {
 protected:
  ObjectTest() { wait_until_up(link_); }

  void put(const std::string& content) {
    const auto done = run<bool>(link_, [&](Storage& storage) {
      return storage.objects.put("test", "a.1/parameters.bin", content).map([] { return true; });
    });
    if (!done) throw std::runtime_error{done.error()};
  }
  tl::expected<Content, std::string> get() {
    return run<Content>(link_, [](Storage& storage) { return storage.objects.get("test", "a.1/parameters.bin"); });
  }
  /// What the server answers to a request of JetStream.
  std::string ask(const std::string& subject, const std::string& body) {
    std::string answer;
    link_.request(subject, body, 5s, [&answer](const Link::Reply& reply) { answer = reply.value(); });
    wait_until([&answer] { return !answer.empty(); });
    return answer;
  }

  Ear ear_;
  Link link_{events_, server_.address(), "test", ear_};
};

std::string pattern(std::size_t size) {
  std::string content(size, '\0');
  for (std::size_t i = 0; i < size; ++i) content[i] = static_cast<char>(i * 7 + i / 256);
  return content;
}

TEST_F(ObjectTest, IsGotAsItWasPut) {
  for (const std::size_t size : {0UL, 1UL, 131'072UL, 300'000UL}) {
    put(pattern(size));
    const auto content = get();
    ASSERT_TRUE(content.has_value()) << content.error();
    EXPECT_EQ(*content, pattern(size)) << size;
  }
}

TEST_F(ObjectTest, IsNotThereBeforeItIsPut) {
  const auto content = get();

  ASSERT_TRUE(content.has_value()) << content.error();
  EXPECT_FALSE(content->has_value());
}

TEST_F(ObjectTest, IsNotThereAfterItWasRemoved) {
  put("content");
  ASSERT_TRUE(run<bool>(link_, [](Storage& storage) {
                return storage.objects.remove("test", "a.1/parameters.bin").map([] { return true; });
              }).has_value());
  const auto content = get();

  ASSERT_TRUE(content.has_value()) << content.error();
  EXPECT_FALSE(content->has_value());
}

TEST_F(ObjectTest, LeavesNothingOfTheFormerOne) {
  put(pattern(300'000));
  put("short");

  const std::string info = ask("$JS.API.STREAM.INFO.OBJ_test", "");
  EXPECT_NE(info.find(R"("messages":2,)"), std::string::npos) << info;
}

TEST_F(ObjectTest, ThatIsDamagedIsAnError) {
  put(pattern(300'000));
  ask("$JS.API.STREAM.MSG.DELETE.OBJ_test", R"({"seq": 2})");
  const auto content = get();

  ASSERT_FALSE(content.has_value());
  EXPECT_EQ(content.error(), "test: the object a.1/parameters.bin is damaged");
}

TEST_F(ObjectTest, OfMoreThanEightMegabytesIsRefused) {
  EXPECT_THROW(put(std::string(ObjectStore::kLongest + 1, 'x')), std::runtime_error);
}

}  // namespace
}  // namespace farm
