#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "text/name.hpp"
#include "tools/canrec/commands/command.hpp"
#include "tools/canrec/commands/limits.hpp"
#include "tools/canrec/server/store.hpp"

namespace canrec {

namespace {

/// A recording keeps so much unless it is told otherwise: nobody shall fill the disk of a server by forgetting it.
constexpr const char* kUsualBytes = "1G";

struct RecordWords {
  std::string url;
  std::string name;
  std::string age;
  std::string bytes = kUsualBytes;
};

Expected<Limits> limits_of(const RecordWords& words) {
  Limits limits;
  if (!words.age.empty()) {
    const auto age = read_age(words.age);
    if (!age)
      return fail(Status::Usage,
                  fmt::format("--max-age: expected seconds or a time as 15m, 12h or 7d, got \"{}\"", words.age));
    limits.age = *age;
  }
  const auto bytes = read_bytes(words.bytes);
  if (!bytes)
    return fail(Status::Usage,
                fmt::format("--max-bytes: expected bytes, a number as 500M or 2G, or 0 for no limit, got \"{}\"",
                            words.bytes));
  limits.bytes = *bytes;
  return limits;
}

Expected<void> record(const RecordWords& words, const nats::ServerOptions& options) {
  const auto url = read_url(words.url, "NAME", options);
  if (!url) return tl::unexpected{url.error()};
  const auto limits = limits_of(words);
  if (!limits) return tl::unexpected{limits.error()};
  if (!text::is_name(words.name))
    return fail(Status::Usage,
                fmt::format("RECORDING: expected a name of {}, got \"{}\"", text::kNameForm, words.name));
  auto store = Store::open(url->server);
  if (!store) return tl::unexpected{store.error()};
  if (auto done = store->begin(url->name, words.name, *limits); !done) return done;
  const auto follows = store->await(words.name);
  if (!follows) return tl::unexpected{follows.error()};
  if (!*follows)
    tell(fmt::format("the server passes over what bus {} has had before; {} begins when it is done", url->name,
                     words.name));
  return {};
}

Expected<Store> store_of(const std::string& text, const nats::ServerOptions& options, std::string& name) {
  auto url = read_url(text, "RECORDING", options);
  if (!url) return tl::unexpected{url.error()};
  name = url->name;
  return Store::open(url->server);
}

Expected<void> stop(const std::string& text, const nats::ServerOptions& options) {
  std::string name;
  auto store = store_of(text, options, name);
  if (!store) return tl::unexpected{store.error()};
  const auto recording = store->stop(name);
  if (!recording) return tl::unexpected{recording.error()};
  tell(fmt::format("{} messages of bus {} are in {}", recording->messages, recording->bus, name));
  return {};
}

Expected<void> remove(const std::string& text, const nats::ServerOptions& options) {
  std::string name;
  auto store = store_of(text, options, name);
  if (!store) return tl::unexpected{store.error()};
  return store->remove(name);
}

}  // namespace

void add_record(CLI::App& app, Run& run) {
  CLI::App& sub = subcommand(app, "record", "Have the server record a bus, also when this program has ended");
  const auto words = std::make_shared<RecordWords>();
  sub.add_option("BUS", words->url, "nats://HOST[:PORT]/NAME or tls://..., as canhub --join has it")
      ->required()
      ->type_name("");
  sub.add_option("RECORDING", words->name, "Name of the recording")->required()->type_name("");
  sub.add_option("--max-age", words->age, "forget what is older: seconds, or 15m, 12h, 7d (default: nothing)")
      ->type_name("T");
  sub.add_option("--max-bytes", words->bytes,
                 "forget the oldest beyond so many bytes: 500M, 2G (default: 1G; 0: nothing)")
      ->type_name("N");
  sub.callback(
      [&run, words] { run = [words](const nats::ServerOptions& options) { return record(*words, options); }; });
}

void add_stop(CLI::App& app, Run& run) {
  CLI::App& sub = subcommand(app, "stop", "End a recording, and keep it");
  const auto url = std::make_shared<std::string>();
  sub.add_option("URL", *url, "nats://HOST[:PORT]/RECORDING or tls://...")->required()->type_name("");
  sub.callback([&run, url] { run = [url](const nats::ServerOptions& options) { return stop(*url, options); }; });
}

void add_remove(CLI::App& app, Run& run) {
  CLI::App& sub = subcommand(app, "remove", "End a recording, and forget it");
  const auto url = std::make_shared<std::string>();
  sub.add_option("URL", *url, "nats://HOST[:PORT]/RECORDING or tls://...")->required()->type_name("");
  sub.callback([&run, url] { run = [url](const nats::ServerOptions& options) { return remove(*url, options); }; });
}

}  // namespace canrec
