#include <gtest/gtest.h>

#include "gateway/streams/viewers.hpp"

namespace gateway {
namespace {

std::string all_of(EventStream& stream, std::size_t size = 7) {
  std::string text;
  for (std::string part(size, ' '); !stream.is_empty();) text += part.substr(0, stream.take(part.data(), size));
  return text;
}

TEST(EventText, IsFramedAsBrowsersReadIt) {
  EXPECT_EQ(*event_text("event", R"({"t":1})", 7), "id: 7\nevent: event\ndata: {\"t\":1}\n\n");
  EXPECT_EQ(*event_text("units", "{}"), "event: units\ndata: {}\n\n");
  EXPECT_EQ(*stream_start(), "retry: 2000\n\n");
  EXPECT_EQ(*heartbeat(), ": alive\n\n");
}

TEST(EventStream, ComesInPartsOfAnySize) {
  EventStream stream;
  stream.push(heartbeat());
  stream.push(stream_start());
  EXPECT_EQ(all_of(stream, 3), ": alive\n\nretry: 2000\n\n");
  EXPECT_FALSE(stream.has_ended());
}

TEST(EventStream, TellsWhenThereIsSomething) {
  EventStream stream;
  int calls = 0;
  stream.listen([&calls] { ++calls; });
  stream.push(heartbeat());
  EXPECT_EQ(calls, 1);
  stream.end();
  EXPECT_EQ(calls, 2);
}

TEST(EventStream, ThatIsNotReadEndsWithAWord) {
  EventStream stream;
  const EventText text = event_text("event", std::string(1000, 'x'));
  std::size_t taken = 0;
  while (stream.push(text)) ++taken;

  EXPECT_EQ(taken, EventStream::kMostUnread / text->size());
  EXPECT_TRUE(stream.was_cut_off());
  EXPECT_TRUE(stream.has_ended());
  EXPECT_FALSE(stream.push(heartbeat()));
  EXPECT_EQ(all_of(stream), "event: cut-off\ndata: {\"message\":\"events came faster than they were read\"}\n\n");
}

TEST(EventStream, ThatIsCutOffInTheMidstOfAnEventKeepsIt) {
  EventStream stream;
  const EventText text = event_text("event", std::string(1000, 'x'));
  stream.push(text);
  std::string part(100, ' ');
  ASSERT_EQ(stream.take(part.data(), part.size()), part.size());
  while (stream.push(text)) {
  }
  const std::string rest = part + all_of(stream);
  EXPECT_TRUE(rest.starts_with(*text));
  EXPECT_EQ(rest.substr(text->size()),
            *event_text("cut-off", R"({"message":"events came faster than they were read"})"));
}

TEST(Viewers, GetWhatTheyWant) {
  Viewers viewers;
  const auto all = viewers.add();
  const auto some = viewers.add({.units = {"vcan0/5"}, .kinds = {"fault"}});
  for (const auto& stream : {all, some}) all_of(*stream);
  viewers.tell(event_text("event", "1"), "vcan0/5", "fault");
  viewers.tell(event_text("event", "2"), "vcan0/6", "fault");
  viewers.tell(event_text("event", "3"), "vcan0/5", "nmt");
  EXPECT_EQ(all_of(*some), *event_text("event", "1"));
  EXPECT_EQ(all_of(*all), *event_text("event", "1") + *event_text("event", "2") + *event_text("event", "3"));
  viewers.remove(*all);
  viewers.remove(*some);
  EXPECT_TRUE(viewers.is_empty());
}

}  // namespace
}  // namespace gateway
