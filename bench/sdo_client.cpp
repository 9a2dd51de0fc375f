#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <poll.h>

#include "bench/raw_socket.hpp"

namespace {

constexpr int kWarmUp = 200;
constexpr int kPatience = 20'000;  // ms; a slave under an instruction counter is slow
constexpr int kUsage = 2;

struct Arguments {
  std::string interface;
  unsigned node = 0;
  unsigned long requests = 0;
  unsigned long process = 0;  // 0: none
};

/// CPU time of all threads of @p process (ns), user and system.
std::uint64_t cpu_time(unsigned long process) {
  std::uint64_t sum = 0;
  for (const auto& thread : std::filesystem::directory_iterator{"/proc/" + std::to_string(process) + "/task"}) {
    std::ifstream file{thread.path() / "schedstat"};
    std::uint64_t on_cpu = 0;
    if (!(file >> on_cpu)) throw std::runtime_error{"no schedstat of the process"};
    sum += on_cpu;
  }
  return sum;
}

/// Uploads 1000h, one request after the other, and insists on the same value every time.
class Client {
 public:
  explicit Client(const Arguments& arguments) : socket_{arguments.interface, 0x580 + arguments.node} {
    request_.can_id = 0x600 + arguments.node;
    request_.can_dlc = 8;
    request_.data[0] = 0x40;
    request_.data[2] = 0x10;
    expected_ = request();
    if (expected_.data[0] != 0x43 || std::memcmp(&expected_.data[1], &request_.data[1], 3) != 0) {
      throw std::runtime_error{"the first answer is not an upload of four bytes of 1000h"};
    }
  }
  void upload(unsigned long times) {
    for (unsigned long i = 0; i < times; ++i) {
      if (std::memcmp(request().data, expected_.data, sizeof expected_.data) != 0) {
        throw std::runtime_error{"an answer differs from the first one"};
      }
    }
  }

 private:
  can_frame request() {
    can_frame answer{};
    pollfd wait{socket_.descriptor(), POLLIN, 0};
    if (!socket_.send(request_)) throw std::runtime_error{"a request cannot be sent"};
    if (::poll(&wait, 1, kPatience) != 1 || !socket_.receive(answer)) throw std::runtime_error{"no answer"};
    return answer;
  }

  bench::RawSocket socket_;
  can_frame request_{};
  can_frame expected_{};
};

int measure(const Arguments& arguments) {
  Client client{arguments};
  client.upload(kWarmUp);
  const std::uint64_t before = arguments.process != 0 ? cpu_time(arguments.process) : 0;
  client.upload(arguments.requests);
  if (arguments.process != 0) {
    std::printf("%llu\n",
                static_cast<unsigned long long>((cpu_time(arguments.process) - before) / arguments.requests));
  }
  return 0;
}

template <class Number>
bool parse(const char* word, Number& number) {
  const char* const end = word + std::strlen(word);
  return std::from_chars(word, end, number).ptr == end && number != 0;
}

}  // namespace

/// Sends SDO requests to a slave and checks every answer; with the slave's process also prints its CPU time a
/// request.
int main(int count, char** words) {
  Arguments arguments;
  const bool valid = (count == 4 || count == 5) && parse(words[2], arguments.node) &&
                     parse(words[3], arguments.requests) && (count == 4 || parse(words[4], arguments.process));
  if (!valid) {
    std::fputs("usage: sdo_client INTERFACE NODE REQUESTS [PROCESS]\n", stderr);
    return kUsage;
  }
  arguments.interface = words[1];
  try {
    return measure(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sdo_client: %s\n", error.what());
    return 1;
  }
}
