#include <future>
#include <memory>

#include "tests/farm/link/link_fixture.hpp"

namespace farm {
namespace {

using namespace std::chrono_literals;

using Revision = std::optional<std::uint64_t>;

class StorageTest : public LinkTest {
 protected:
  StorageTest() { wait_until_up(link_); }

  Revision update(const std::string& value, std::uint64_t revision) {
    const auto done = run<Revision>(
        link_, [&](Storage& storage) { return storage.keys.update("test", "a.1", value, revision); });
    if (!done) throw std::runtime_error{done.error()};
    return *done;
  }
  std::uint64_t put(const std::string& key, const std::string& value) {
    return run<std::uint64_t>(link_, [&](Storage& storage) { return storage.keys.put("test", key, value); })
        .value();
  }
  void remove(const std::string& key) {
    run<bool>(link_, [&](Storage& storage) {
      return storage.keys.remove("test", key).map([] { return true; });
    }).value();
  }

  Ear ear_;
  Link link_{events_, server_.address(), "test", ear_};
};

TEST_F(StorageTest, KeepsWhatIsPut) {
  const std::uint64_t revision = put("a.1", "value");
  const auto entry =
      run<std::optional<Entry>>(link_, [](Storage& storage) { return storage.keys.get("test", "a.1"); });

  ASSERT_TRUE(entry.has_value() && entry->has_value());
  EXPECT_EQ((*entry)->key, "a.1");
  EXPECT_EQ((*entry)->value, "value");
  EXPECT_EQ((*entry)->revision, revision);
}

TEST_F(StorageTest, HasNothingUnderAnotherKeyOrOneThatWasRemoved) {
  put("a.1", "value");
  remove("a.1");
  for (const char* const key : {"a.1", "a.2"}) {
    const auto entry =
        run<std::optional<Entry>>(link_, [key](Storage& storage) { return storage.keys.get("test", key); });
    ASSERT_TRUE(entry.has_value()) << entry.error();
    EXPECT_FALSE(entry->has_value());
  }
}

/// The bucket of a watch is made, and somebody is to be told of a job, who asks for more: nothing of it was served
/// yet.
TEST_F(StorageTest, TellsThoseWhoWaitWhenTheLinkGoes) {
  auto link = std::make_unique<Link>(events_, server_.address(), "going", ear_);
  wait_until_up(*link);
  std::promise<void> is_done;
  std::vector<Link::Reply> replies;
  link->watch(
      "other", ">", [](const Entry&) {}, [] {});
  link->run<bool>([&is_done](Storage&) { return is_done.set_value(), true; },
                  [&, asked = link.get()](const auto& result) {
                    ASSERT_TRUE(result.has_value()) << result.error();
                    asked->request("nobody", "", 1s,
                                   [&replies](const Link::Reply& reply) { replies.push_back(reply); });
                  });
  is_done.get_future().wait();

  link.reset();
  ASSERT_EQ(replies.size(), 1U);
  EXPECT_EQ(replies[0].error(), NoReply::Down);
}

TEST_F(StorageTest, TellsAllThatIsThere) {
  put("a.1", "one");
  put("a.2", "two");
  put("a.3", "three");
  remove("a.2");
  const auto all = run<std::vector<Entry>>(link_, [](Storage& storage) { return storage.keys.all("test"); });

  ASSERT_TRUE(all.has_value()) << all.error();
  ASSERT_EQ(all->size(), 2);
  EXPECT_EQ(all->front().value, "one");
  EXPECT_EQ(all->back().value, "three");
}

TEST_F(StorageTest, HasNothingInABucketThatIsNew) {
  const auto all = run<std::vector<Entry>>(link_, [](Storage& storage) { return storage.keys.all("test"); });

  ASSERT_TRUE(all.has_value()) << all.error();
  EXPECT_TRUE(all->empty());
}

TEST_F(StorageTest, UpdatesOnlyWhatNobodyElseHasChanged) {
  const Revision first = update("one", 0);
  ASSERT_TRUE(first.has_value());
  EXPECT_FALSE(update("again", 0).has_value());
  const Revision second = update("two", *first);
  ASSERT_TRUE(second.has_value());
  EXPECT_FALSE(update("late", *first).has_value());
  EXPECT_TRUE(update("three", *second).has_value());
}

TEST_F(StorageTest, MakesAKeyThatWasRemoved) {
  put("a.1", "value");
  remove("a.1");

  EXPECT_TRUE(update("new", 0).has_value());
  EXPECT_FALSE(update("once more", 0).has_value());
}

TEST_F(StorageTest, FailsAtOnceWithoutAConnection) {
  server_.kill();
  wait_until([this] { return !link_.is_up(); });
  const auto all = run<std::vector<Entry>>(link_, [](Storage& storage) { return storage.keys.all("test"); });

  ASSERT_FALSE(all.has_value());
  EXPECT_EQ(all.error(), "no connection");
}

TEST_F(StorageTest, FailsWhileTheServerStandsStill) {
  put("a.1", "value");
  server_.stop();
  const auto all = run<std::vector<Entry>>(link_, [](Storage& storage) { return storage.keys.all("test"); });
  server_.go_on();

  EXPECT_FALSE(all.has_value());
}

class WatchTest : public StorageTest {
 protected:
  WatchTest() {
    link_.watch(
        "test", "a.*",
        [this](const Entry& entry) {
          told_.push_back(entry.is_deleted ? entry.key + " gone" : entry.key + '=' + entry.value);
        },
        [this] { told_.push_back("all"); });
  }
  void wait_until_told(std::size_t count) {
    wait_until([this, count] { return told_.size() >= count; });
  }

  using Told = std::vector<std::string>;
  Told told_;
};

TEST_F(WatchTest, OfAnEmptyBucketTellsThatItWasAll) {
  wait_until_told(1);

  EXPECT_EQ(told_, Told{"all"});
}

/// A bucket keeps the last value of a key: who is told late is not told of those before.
TEST_F(WatchTest, TellsChangesAsTheyCome) {
  wait_until_told(1);
  put("a.1", "one");
  wait_until_told(2);
  put("b.1", "not watched");
  put("a.1", "two");
  wait_until_told(3);
  remove("a.1");
  wait_until_told(4);

  EXPECT_EQ(told_, (Told{"all", "a.1=one", "a.1=two", "a.1 gone"}));
}

TEST_F(WatchTest, TellsAllAnewWhenTheServerWasStartedAgain) {
  wait_until_told(1);
  put("a.1", "one");
  put("a.2", "two");
  wait_until_told(3);
  told_.clear();
  server_.kill();
  wait_until([this] { return !link_.is_up(); });
  server_.start();
  wait_until_told(3);
  put("a.3", "three");
  wait_until_told(4);

  EXPECT_EQ(told_, (Told{"a.1=one", "a.2=two", "all", "a.3=three"}));
}

TEST_F(WatchTest, TellsAllAnewWhenTheServerHasStoodStill) {
  wait_until_told(1);
  put("a.1", "one");
  wait_until_told(2);
  told_.clear();
  server_.stop();
  wait_until([this] { return !link_.is_up(); });
  server_.go_on();
  wait_until_told(2);

  EXPECT_EQ(told_, (Told{"a.1=one", "all"}));
}

TEST_F(WatchTest, OfABucketThatIsRemovedGoesOnInANewOne) {
  wait_until_told(1);
  std::string gone;
  link_.request("$JS.API.STREAM.DELETE.KV_test", "", 5s,
                [&gone](const Link::Reply& reply) { gone = reply.value(); });
  wait_until([&gone] { return !gone.empty(); });
  wait_until_told(2);
  put("a.1", "one");
  wait_until_told(3);

  EXPECT_EQ(told_, (Told{"all", "all", "a.1=one"}));
}

}  // namespace
}  // namespace farm
