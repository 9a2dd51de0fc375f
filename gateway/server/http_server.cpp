#include "gateway/server/http_server.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include "gateway/server/listener.hpp"
#include "gateway/server/turn.hpp"
#include "os/clock.hpp"

namespace gateway {
namespace {

constexpr unsigned kMostConnections = 1024;  // at one address
constexpr std::size_t kHeaderMemory = 32UL * 1024;
constexpr unsigned kIdle = 15;  // s without a byte, while something is sent
constexpr std::size_t kStreamBlock = 16UL * 1024;
constexpr std::chrono::seconds kSecond{1};
constexpr int kMostRuns = 16;  // at a time, for others have their turns too
constexpr std::string_view kTooLate =
    "HTTP/1.1 408 Request Timeout\r\nConnection: close\r\nContent-Length: 0\r\n\r\n";

using HeaderRow = std::array<const char*, 2>;
/// Of every answer: nothing is kept, nothing is shown as what it is not, nothing is put into a frame.
constexpr std::array kHeaders{HeaderRow{"Cache-Control", "no-store"},
                              HeaderRow{"Content-Security-Policy", "default-src 'none'; frame-ancestors 'none'"},
                              HeaderRow{"Referrer-Policy", "no-referrer"},
                              HeaderRow{"X-Content-Type-Options", "nosniff"}};

bool has_header(const Response& response, std::string_view name) noexcept {
  return std::ranges::any_of(response.headers, [name](const auto& header) { return header.first == name; });
}

}  // namespace

std::int64_t HttpServer::now() noexcept {
  return std::chrono::duration_cast<std::chrono::microseconds>(os::monotonic_time()).count();
}

HttpServer::HttpServer(axisd::ServiceEvents& events, const std::vector<Authority>& addresses, Requests& requests)
    : events_{events}, requests_{requests} {
  for (const Authority& address : addresses) open(doors_.emplace_back(), address);
  second_ = events_.timer(
      [](sd_event_source*, std::uint64_t, void* self) noexcept {
        static_cast<HttpServer*>(self)->look_for_late_ones();
        return 0;
      },
      this);
  axisd::ServiceEvents::start(second_, kSecond);
}

HttpServer::~HttpServer() {
  for (Turn* const turn : turns_) {
    turn->exchange->answer(refuse(Refused::NoDaemon, "the server ends"));
    if (turn->exchange->stream_) turn->exchange->stream_->end();
    turn->resume();  // a server that is stopped must have none that is suspended
  }
  for (Door& door : doors_) {
    if (door.daemon == nullptr) continue;
    MHD_quiesce_daemon(door.daemon);
    for (int runs = 0; runs < kMostRuns; ++runs) MHD_run(door.daemon);
    for (Turn* const turn : turns_) turn->resume();
    MHD_stop_daemon(door.daemon);
  }
}

void HttpServer::open(Door& door, const Authority& address) {
  Authority& own = addresses_.emplace_back(address);
  door.server = this;
  door.listener = listen_at(own);
  door.daemon = MHD_start_daemon(
      MHD_USE_EPOLL | MHD_ALLOW_SUSPEND_RESUME, 0, nullptr, nullptr, &Callbacks::on_access, &door,
      MHD_OPTION_LISTEN_SOCKET, door.listener.get(), MHD_OPTION_CONNECTION_LIMIT, kMostConnections,
      MHD_OPTION_CONNECTION_MEMORY_LIMIT, kHeaderMemory, MHD_OPTION_CONNECTION_TIMEOUT, kIdle,
      MHD_OPTION_STRICT_FOR_CLIENT, 1, MHD_OPTION_SIGPIPE_HANDLED_BY_APP, 1, MHD_OPTION_NOTIFY_CONNECTION,
      &Callbacks::on_connection, &door, MHD_OPTION_NOTIFY_COMPLETED, &Callbacks::on_completed, &door,
      MHD_OPTION_UNESCAPE_CALLBACK, &Callbacks::keep_encoded, &door, MHD_OPTION_END);
  if (door.daemon == nullptr) throw std::runtime_error{fmt::format("{}: cannot be served", own.text())};
  const MHD_DaemonInfo* const info = MHD_get_daemon_info(door.daemon, MHD_DAEMON_INFO_EPOLL_FD);
  door.source = events_.watch(
      info->epoll_fd, EPOLLIN,
      [](sd_event_source*, int, std::uint32_t, void* self) noexcept {
        run(*static_cast<Door*>(self));
        return 0;
      },
      &door);
  door.timer = events_.timer(
      [](sd_event_source*, std::uint64_t, void* self) noexcept {
        run(*static_cast<Door*>(self));
        return 0;
      },
      &door);
}

void HttpServer::run(Door& door) noexcept {
  unsigned long long wait = 0;
  for (int runs = 0; runs < kMostRuns; ++runs) {
    MHD_run(door.daemon);
    if (MHD_get_timeout(door.daemon, &wait) != MHD_YES) return;
    if (wait != 0) break;
  }
  axisd::ServiceEvents::start(door.timer, std::chrono::milliseconds{wait});
}

/// The library waits as long as now and then a byte comes.
void HttpServer::look_for_late_ones() noexcept {
  const std::int64_t present = now();
  for (Connection& connection : connections_) {
    if (!connection.deadline || *connection.deadline > present) continue;
    connection.deadline.reset();
    ++counters_.late_requests;
    // Nothing is being sent: there is no request that has an answer.
    ::send(connection.descriptor, kTooLate.data(), kTooLate.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    ::shutdown(connection.descriptor, SHUT_RDWR);
  }
  axisd::ServiceEvents::start(second_, kSecond);
}

bool HttpServer::send(MHD_Connection& connection, Turn& turn) {
  Exchange& exchange = *turn.exchange;
  turn.from->deadline.reset();
  Response& response = *exchange.response_;
  MHD_Response* const built =
      exchange.stream_
          ? MHD_create_response_from_callback(MHD_SIZE_UNKNOWN, kStreamBlock, &Callbacks::on_room, &turn, nullptr)
          : MHD_create_response_from_buffer(response.text().size(), const_cast<char*>(response.text().data()),
                                            MHD_RESPMEM_PERSISTENT);
  if (built == nullptr) return false;
  for (const HeaderRow& row : kHeaders)
    if (!has_header(response, row[0])) MHD_add_response_header(built, row[0], row[1]);
  if (!response.content_type.empty())
    MHD_add_response_header(built, MHD_HTTP_HEADER_CONTENT_TYPE, response.content_type.c_str());
  for (const auto& list : {response.headers, exchange.headers_})
    for (const auto& [name, value] : list) MHD_add_response_header(built, name.c_str(), value.c_str());
  ++counters_.answers[static_cast<unsigned>(response.status)];
  const MHD_Result queued = MHD_queue_response(&connection, static_cast<unsigned>(response.status), built);
  MHD_destroy_response(built);
  if (!exchange.stream_) return queued == MHD_YES;
  ++counters_.viewers;
  turn.is_streaming = true;
  exchange.stream_->listen([&turn] { turn.resume(); });
  return queued == MHD_YES;
}

}  // namespace gateway
