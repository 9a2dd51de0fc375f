#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <unistd.h>

#include "bench/number.hpp"
#include "bench/trunk/load.hpp"
#include "bench/trunk/sequencer_stream.hpp"
#include "can/hub/path/path_owner.hpp"
#include "can/hub/server.hpp"
#include "can/hub/trunk/trunk.hpp"
#include "can/nats/nats_stream.hpp"

/// `canhub --join` with what a measurement needs: over a NATS server or over the sequencer, the size of messages,
/// traffic of its own, and all figures at its end.
namespace {

constexpr int kUsage = 2;

struct Options {
  std::string stream;
  std::string path;
  std::size_t frames_a_message = 1;
  bench::Load::Settings load;
};

std::optional<Options> read(int count, char** words) {
  constexpr int kWords = 7;
  constexpr unsigned kMostSenders = 256;
  constexpr std::uint32_t kMostFrames = 1'000'000'000;
  Options options;
  if (count != kWords ||
      !bench::parse<std::size_t>(words[3], 1, hub::trunk::kMostFrames, options.frames_a_message) ||
      !bench::parse(words[4], 1U, kMostSenders, options.load.senders) ||
      !bench::parse(words[5], 0U, options.load.senders - 1, options.load.sender) ||
      !bench::parse(words[6], std::uint32_t{0}, kMostFrames, options.load.count))
    return std::nullopt;
  options.stream = words[1];
  options.path = words[2];
  return options;
}

std::unique_ptr<hub::trunk::Stream> open(const std::string& url) {
  constexpr std::string_view kTcp = "tcp://";
  if (url.starts_with(kTcp)) return std::make_unique<bench::SequencerStream>(url.substr(kTcp.size()));
  auto bus = nats::parse_bus(url);
  if (!bus) throw std::runtime_error{bus.error()};
  return std::make_unique<nats::NatsStream>(*std::move(bus));
}

void tell(std::string_view line) noexcept {
  std::printf("%.*s\n", static_cast<int>(line.size()), line.data());
  std::fflush(stdout);
}

/// Standard input: a line begins the traffic, its end that of the hub.
class Orders final : public hub::Source {
 public:
  Orders(hub::Server& server, bench::Load& load) : server_{server}, load_{load} {
    ::fcntl(STDIN_FILENO, F_SETFL, O_NONBLOCK);
    server_.add(*this);
  }
  ~Orders() override { server_.remove(*this); }

  [[nodiscard]] int descriptor() const noexcept override { return STDIN_FILENO; }
  void on_readable(canopen::TimePoint now) noexcept override {
    char line[64];
    const ssize_t size = ::read(STDIN_FILENO, line, sizeof line);
    if (size > 0) load_.begin(now);
    if (size == 0) server_.stop();
  }

 private:
  hub::Server& server_;
  bench::Load& load_;
};

void run(const Options& options) {
  userbus::Path path{};
  if (!userbus::copy_path(options.path.c_str(), path)) throw std::runtime_error{"the path is too long"};
  auto owner = hub::PathOwner::take(path, {});
  if (!owner) throw std::runtime_error{owner.error().text};
  hub::Server server{owner->listener(), {}};
  server.lengthen();
  hub::trunk::Trunk trunk{
      server.medium(), open(options.stream),
      hub::trunk::Trunk::Settings{
          .url = options.stream, .name = options.path, .frames_a_message = options.frames_a_message},
      [&server](bool up, canopen::TimePoint /*now*/) { server.set_link(up); }, tell};
  server.add(trunk);
  bench::Load load{server.medium(), options.load, [] { tell("complete"); }};
  const Orders orders{server, load};
  server.run();
  constexpr std::size_t kMostOfReport = 8192;
  tell(trunk.report(kMostOfReport));
  tell(load.tally().report());
  server.remove(trunk);
}

}  // namespace

int main(int count, char** words) {
  const auto options = read(count, words);
  if (!options) {
    std::fputs(
        "usage: trunk_hub nats://HOST[:PORT]/NAME|tcp://ADDRESS:PORT PATH FRAMES-A-MESSAGE HUBS NUMBER COUNT\n",
        stderr);
    return kUsage;
  }
  try {
    run(*options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "trunk_hub: %s\n", error.what());
    return 1;
  }
}
