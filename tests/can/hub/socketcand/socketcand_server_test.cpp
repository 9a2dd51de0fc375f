#include "tests/can/hub/socketcand/socketcand_fixture.hpp"

namespace {

using namespace socketcand_test;

TEST_F(SocketcandServer, AnswersEachStepOfTheHandshakeByItself) {
  Client client{*this};

  EXPECT_EQ(client.hear(), "< hi >");
  EXPECT_EQ(client.ask("< open vcan0 >"), "< ok >");
  EXPECT_EQ(client.ask("< rawmode >"), "< ok >");
}

TEST_F(SocketcandServer, TellsFramesOfTheBus) {
  Client client{*this};
  client.join();

  arrive("123#1A220344");
  EXPECT_EQ(without_time(client.hear()), "\n< frame 123 TIME 1A220344 >");
  arrive("18DAF110#");
  EXPECT_EQ(without_time(client.hear()), "\n< frame 18DAF110 TIME  >");
}

TEST_F(SocketcandServer, TellsTheTimeOfAFrameInMicroseconds) {
  Client client{*this};
  client.join();

  arrive("123#");

  char expected[64];
  const std::int64_t time_us = member.passages.back().time_ns / 1000;
  std::snprintf(expected, sizeof expected, "\n< frame 123 %lld.%06lld  >",
                static_cast<long long>(time_us / 1'000'000), static_cast<long long>(time_us % 1'000'000));
  EXPECT_EQ(client.hear(), expected);
}

TEST_F(SocketcandServer, SendsFramesOfAClientToAllButItself) {
  Client client{*this}, other{*this};
  client.join();
  other.join();

  client.say("< send 123 2 1 f1 >");

  EXPECT_EQ(member.seen, Texts{"123#01F1"});
  EXPECT_FALSE(member.passages[0].local);
  EXPECT_EQ(interfaces.name_of(member.passages[0].interface_index), "can0");
  EXPECT_EQ(without_time(other.hear()), "\n< frame 123 TIME 01F1 >");
  EXPECT_TRUE(client.hears_nothing());
}

TEST_F(SocketcandServer, SendsFramesOfAClientThatHasNotChangedToRawMode) {
  Client client{*this};
  client.hear();
  client.ask("< open can0 >");

  client.say("< send 123 0 >");
  arrive("124#");

  EXPECT_EQ(member.seen, (Texts{"123#", "124#"}));
  EXPECT_TRUE(client.hears_nothing());
}

TEST_F(SocketcandServer, TakesManyMessagesOfOneSegmentAndOneMessageOfMany) {
  Client client{*this};
  client.join();

  client.say("< send 001 0 >< send 002 0 >\n< send 003");
  EXPECT_EQ(member.seen, (Texts{"001#", "002#"}));
  client.say(" 0 >");

  EXPECT_EQ(member.seen.back(), "003#");
}

TEST_F(SocketcandServer, AnswersAnEcho) {
  Client client{*this};
  client.hear();

  EXPECT_EQ(client.ask("< echo >"), "< echo >");
}

TEST_F(SocketcandServer, SaysWhatIsWrong) {
  Client client{*this};
  client.hear();

  EXPECT_EQ(client.ask("< rawmode >"), "< error open a bus first >");
  EXPECT_EQ(client.ask("< send 123 0 >"), "< error open a bus first >");
  EXPECT_EQ(client.ask("< open eth0 >"), "< error a bus is called can0, vcan1 or the like, not: eth0 >");
  EXPECT_EQ(client.ask("< open can0 >"), "< ok >");
  EXPECT_EQ(client.ask("< open can1 >"), "< error the bus is open already >");
  EXPECT_EQ(client.ask("< subscribe 0 0 123 >"), "< error unknown command: subscribe 0 0 123 >");
  EXPECT_EQ(client.ask("< send 123 9 >"), "< error send expects a length of 0 to 8: send 123 9 >");
  EXPECT_EQ(client.ask("< hi >"), "< error a client does not say that: hi >");
}

TEST_F(SocketcandServer, RefusesAnEndlessMessageOnceAndGoesOn) {
  Client client{*this};
  client.hear();

  EXPECT_EQ(client.ask("< " + std::string(2000, 'x')), "< error a message has at most 256 characters >");
  client.say(std::string(2000, 'x'));
  EXPECT_TRUE(client.hears_nothing());
  EXPECT_EQ(client.ask(" >< echo >"), "< echo >");
}

TEST_F(SocketcandServer, TellsNoFrameRightBehindTheAnswerToRawMode) {
  Client client{*this};
  client.hear();
  client.ask("< open can0 >");
  client.say("< rawmode >");
  arrive("123#01");

  EXPECT_EQ(client.hear(), "< ok >");
  EXPECT_TRUE(client.hears_nothing());
  EXPECT_EQ(server.next_deadline(), now + Session::kSilence);
  pass(Session::kSilence);
  EXPECT_EQ(without_time(client.hear()), "\n< frame 123 TIME 01 >");
  EXPECT_EQ(server.next_deadline(), canopen::kNever);
}

TEST_F(SocketcandServer, TellsFramesAsSoonAsTheClientSaysSomethingInRawMode) {
  Client client{*this};
  client.hear();
  client.ask("< open can0 >");
  client.ask("< rawmode >");
  arrive("123#01");

  client.say("< send 7FF 0 >");

  EXPECT_EQ(without_time(client.hear()), "\n< frame 123 TIME 01 >");
}

TEST_F(SocketcandServer, CountsRemoteAndErrorFramesThatItCannotTell) {
  Client client{*this};
  client.join();
  arrive("705#R");
  hub::Passage error = passage(member, "004#");
  error.frame.can_id |= CAN_ERR_FLAG;
  medium.send(error, now);

  EXPECT_TRUE(client.hears_nothing());
  EXPECT_EQ(row().dropped, 2u);
}

}  // namespace
