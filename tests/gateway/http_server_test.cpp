#include "gateway/server/http_server.hpp"

#include <gtest/gtest.h>

#include "tests/gateway/gateway_fixture.hpp"

namespace gateway {
namespace {

/// A server that answers at once, later or by a stream, as the path says.
class HttpServerTest : public testing::Test, public HttpServer::Requests {
 protected:
  void on_headers(Exchange& exchange) override {
    if (exchange.request().path == "/early") exchange.answer(refuse(Refused::ReadOnly, "early"));
  }
  void on_request(const std::shared_ptr<Exchange>& exchange) override {
    const Request& request = exchange->request();
    if (request.path == "/later") {
      later.push_back(exchange);
    } else if (request.path == "/stream") {
      exchange->stream(stream, [this] { ++gone; });
    } else {
      exchange->answer(Response{.body = request.verb + ' ' + std::to_string(request.body.size())});
    }
  }
  std::unique_ptr<HttpClient> client() {
    return std::make_unique<HttpClient>(events, server.addresses().front().port.value());
  }
  std::string get(const std::string& path) {
    const auto one = client();
    one->send("GET " + path + " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
    return one->rest();
  }
  std::string post(std::size_t size) {
    const auto one = client();
    one->send("POST / HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\nContent-Length: " +
              std::to_string(size) + "\r\n\r\n" + std::string(size, 'x'));
    return one->rest();
  }

  axisd::ServiceEvents events{[] {}};
  std::list<std::shared_ptr<Exchange>> later;
  std::shared_ptr<EventStream> stream = std::make_shared<EventStream>();
  int gone = 0;
  HttpServer server{events, {{"127.0.0.1", 0}}, *this};
};

TEST_F(HttpServerTest, AnswersAtOnce) {
  const std::string answer = get("/");
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 200 OK\r\n")) << answer;
  EXPECT_TRUE(answer.ends_with("\r\n\r\nGET 0")) << answer;
  for (const char* const header :
       {"X-Content-Type-Options: nosniff\r\n", "Content-Security-Policy: default-src 'none'",
        "Cache-Control: no-store\r\n", "Content-Type: application/json\r\n"})
    EXPECT_NE(answer.find(header), std::string::npos) << header;
}

TEST_F(HttpServerTest, AnswersLaterAndInTheMeantimeOthers) {
  const auto one = client();
  one->send("GET /later HTTP/1.1\r\nHost: localhost\r\n\r\n");
  wait_until(events, [this] { return later.size() == 1; });
  EXPECT_NE(get("/").find("GET 0"), std::string::npos);
  later.front()->answer(Response{.body = "at last"});
  EXPECT_TRUE(one->read_until("at last").ends_with("at last"));
}

TEST_F(HttpServerTest, WhoHasLeftIsNotMissed) {
  client()->send("GET /later HTTP/1.1\r\nHost: localhost\r\n\r\n");
  wait_until(events, [this] { return later.size() == 1; });
  later.front()->answer(Response{.body = "too late"});
  wait_until(events, [this] { return server.counters().connections == 0; });
  later.front()->answer(Response{.body = "again"});
}

TEST_F(HttpServerTest, StreamsUntilTheyEnd) {
  const auto one = client();
  one->send("GET /stream HTTP/1.1\r\nHost: localhost\r\n\r\n");
  stream->push(stream_start());
  EXPECT_NE(one->read_until("retry: 2000").find("text/event-stream"), std::string::npos);
  EXPECT_EQ(server.counters().viewers, 1U);
  stream->push(heartbeat());
  EXPECT_NE(one->read_until(": alive").find(": alive"), std::string::npos);
  stream->end();
  wait_until(events, [this] { return gone == 1; });
  EXPECT_EQ(server.counters().viewers, 0U);
}

TEST_F(HttpServerTest, NoticesAViewerThatHasLeft) {
  auto one = client();
  one->send("GET /stream HTTP/1.1\r\nHost: localhost\r\n\r\n");
  wait_until(events, [this] { return server.counters().viewers == 1; });
  one.reset();
  wait_until(events, [this] {
    stream->push(heartbeat());
    return gone == 1;
  });
}

TEST_F(HttpServerTest, BodiesAreOfALengthThatCanBeTaken) {
  EXPECT_NE(post(65536).find("POST 65536"), std::string::npos);
  EXPECT_NE(post(65537).find("413"), std::string::npos);
}

TEST_F(HttpServerTest, ABodyInPiecesIsBoundedToo) {
  const auto one = client();
  one->send("POST / HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\nTransfer-Encoding: chunked\r\n\r\n");
  for (int n = 0; n < 20; ++n) one->send("1000\r\n" + std::string(4096, 'x') + "\r\n");
  one->send("0\r\n\r\n");
  EXPECT_NE(one->rest().find("413"), std::string::npos);
}

TEST_F(HttpServerTest, RefusesBeforeTheBodyComes) {
  const auto one = client();
  one->send("POST /early HTTP/1.1\r\nHost: localhost\r\nContent-Length: 1000000\r\nExpect: 100-continue\r\n\r\n");
  const std::string answer = one->rest();
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 403 ")) << answer;
}

TEST_F(HttpServerTest, HeadersAreBounded) {
  const auto one = client();
  one->send("GET / HTTP/1.1\r\nHost: localhost\r\nX: " + std::string(100000, 'x') + "\r\n\r\n");
  EXPECT_TRUE(one->rest().find("HTTP/1.1 200") == std::string::npos);
}

TEST_F(HttpServerTest, WhatIsNoRequestIsNoHarm) {
  for (const std::string junk :
       {"\r\n\r\n", "GET\r\n\r\n", "\x16\x03\x01\x02", "GET / HTTP/1.1\r\n\r\n",
        "GET / HTTP/9.9\r\nHost: localhost\r\n\r\n", "PUT / HTTP/1.1\r\nContent-Length: x\r\n\r\n"})
    client()->send(junk);
  EXPECT_NE(get("/").find("GET 0"), std::string::npos);
}

TEST_F(HttpServerTest, EndsWhileClientsWait) {
  const auto one = client();
  const auto two = client();
  one->send("GET /later HTTP/1.1\r\nHost: localhost\r\n\r\n");
  two->send("GET /stream HTTP/1.1\r\nHost: localhost\r\n\r\n");
  wait_until(events, [this] { return later.size() == 1 && server.counters().viewers == 1; });
}

TEST(HttpServerStart, AnAddressThatIsTakenIsSaid) {
  struct Nobody : HttpServer::Requests {
    void on_headers(Exchange&) override {}
    void on_request(const std::shared_ptr<Exchange>&) override {}
  } nobody;
  axisd::ServiceEvents events{[] {}};
  const HttpServer first{events, {{"127.0.0.1", 0}}, nobody};
  try {
    const HttpServer second{events, first.addresses(), nobody};
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string{error.what()},
              first.addresses().front().text() + ": cannot be served: Address already in use");
  }
}

}  // namespace
}  // namespace gateway
