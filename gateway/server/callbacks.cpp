#include <cstring>

#include <fmt/format.h>

#include "gateway/server/turn.hpp"
#include "os/clock.hpp"

namespace gateway {
namespace {

/// For a request to come, from the opening of its connection or the end of the one before (µs).
constexpr std::int64_t kPatience = 10'000'000;

MHD_Result keep_pair(void* list, MHD_ValueKind, const char* key, const char* value) noexcept {
  static_cast<std::vector<std::pair<std::string, std::string>>*>(list)->emplace_back(
      key, value == nullptr ? "" : value);
  return MHD_YES;
}

Request request_of(MHD_Connection* connection, const char* path, const char* verb) {
  Request request{.verb = verb, .path = path};
  MHD_get_connection_values(connection, MHD_GET_ARGUMENT_KIND, keep_pair, &request.query);
  MHD_get_connection_values(connection, MHD_HEADER_KIND, keep_pair, &request.headers);
  return request;
}

}  // namespace

void HttpServer::Callbacks::on_connection(void* door, MHD_Connection* connection, void** context,
                                          MHD_ConnectionNotificationCode code) noexcept {
  auto& self = *static_cast<Door*>(door)->server;
  if (code == MHD_CONNECTION_NOTIFY_STARTED) {
    const MHD_ConnectionInfo* const info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CONNECTION_FD);
    *context = &self.connections_.emplace_back(Connection{info->connect_fd, HttpServer::now() + kPatience});
  } else {
    self.connections_.remove_if([context](const Connection& known) { return &known == *context; });
  }
  self.counters_.connections = self.connections_.size();
}

// NOLINTNEXTLINE(readability-function-size): the library's parameters
MHD_Result HttpServer::Callbacks::on_access(void* door, MHD_Connection* connection, const char* path,
                                            const char* verb, const char*, const char* data, std::size_t* size,
                                            void** turn) noexcept {
  if (*turn == nullptr) {
    *turn = begin(*static_cast<Door*>(door), connection, request_of(connection, path, verb));
    return answer_if_there(*static_cast<Turn*>(*turn));
  }
  Turn& present = *static_cast<Turn*>(*turn);
  if (*size != 0) {
    take_body(present, {data, *size});
    *size = 0;
    return MHD_YES;
  }
  if (!present.is_whole) finish(present);
  if (present.exchange->response_) return answer_if_there(present);
  present.exchange->on_answer_ = [&present] { present.resume(); };
  present.suspend();
  return MHD_YES;
}

HttpServer::Turn* HttpServer::Callbacks::begin(Door& door, MHD_Connection* connection, Request request) {
  const MHD_ConnectionInfo* const info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_SOCKET_CONTEXT);
  auto turn = std::make_unique<Turn>(Turn{&door, connection, static_cast<Connection*>(info->socket_context),
                                          std::make_shared<Exchange>(std::move(request))});
  door.server->turns_.push_back(turn.get());
  door.server->requests_.on_headers(*turn->exchange);
  return turn.release();
}

void HttpServer::Callbacks::take_body(Turn& turn, std::string_view part) {
  std::string& body = turn.exchange->request_.body;
  turn.is_too_long = turn.is_too_long || body.size() + part.size() > kLongestBody;
  if (!turn.is_too_long) body.append(part);
}

void HttpServer::Callbacks::finish(Turn& turn) {
  turn.is_whole = true;
  turn.from->deadline.reset();
  if (turn.is_too_long)
    turn.exchange->answer(refuse(Refused::TooLong, fmt::format("the body is longer than {} bytes", kLongestBody)));
  else
    turn.door->server->requests_.on_request(turn.exchange);
}

MHD_Result HttpServer::Callbacks::answer_if_there(Turn& turn) {
  const bool is_done = !turn.exchange->response_ || turn.door->server->send(*turn.connection, turn);
  return is_done ? MHD_YES : MHD_NO;
}

void HttpServer::Callbacks::on_completed(void* door, MHD_Connection*, void** turn,
                                         MHD_RequestTerminationCode) noexcept {
  auto& self = *static_cast<Door*>(door)->server;
  const std::unique_ptr<Turn> present{static_cast<Turn*>(*turn)};
  if (!present) return;
  *turn = nullptr;
  self.turns_.remove(present.get());
  present->from->deadline = HttpServer::now() + kPatience;
  Exchange& exchange = *present->exchange;
  exchange.is_over_ = true;
  exchange.on_answer_ = {};
  if (!exchange.stream_) return;
  if (present->is_streaming) --self.counters_.viewers;
  if (exchange.stream_->was_cut_off()) ++self.counters_.cut_off_viewers;
  exchange.stream_->listen({});
  exchange.on_gone_();
}

ssize_t HttpServer::Callbacks::on_room(void* turn, std::uint64_t, char* to, std::size_t size) noexcept {
  Turn& present = *static_cast<Turn*>(turn);
  EventStream& stream = *present.exchange->stream_;
  if (!stream.is_empty()) return static_cast<ssize_t>(stream.take(to, size));
  if (stream.has_ended()) return MHD_CONTENT_READER_END_OF_STREAM;
  present.suspend();
  return 0;
}

std::size_t HttpServer::Callbacks::keep_encoded(void*, MHD_Connection*, char* text) noexcept {
  return std::strlen(text);
}

}  // namespace gateway
