#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tools/canrec/commands/command.hpp"
#include "tools/canrec/commands/log_check.hpp"
#include "tools/canrec/frames/log_frames.hpp"
#include "tools/canrec/server/log_upload.hpp"

namespace canrec {

namespace {

struct ImportWords {
  LogChoice log;
  std::string url;
};

/// How many frames were sent.
Expected<std::uint64_t> upload(Store& store, const std::string& name, FrameSource& frames) {
  auto upload = LogUpload::open(store, name);
  if (!upload) return tl::unexpected{upload.error()};
  for (;;) {
    const auto frame = frames.next();
    if (!frame) return tl::unexpected{frame.error()};
    auto done = *frame ? upload->add(**frame) : upload->finish();
    if (!done) return tl::unexpected{done.error()};
    if (!*frame) break;
  }
  if (auto done = store.seal(name); !done) return tl::unexpected{done.error()};
  return upload->frames();
}

Expected<void> import_log(const ImportWords& words, const nats::ServerOptions& options) {
  const auto url = read_url(words.url, "RECORDING", options);
  if (!url) return tl::unexpected{url.error()};
  const auto interface = check_log(words.log);
  if (!interface) return tl::unexpected{interface.error()};
  auto log = LogFrames::open(words.log.path, *interface, [](std::string_view) {});
  if (!log) return tl::unexpected{log.error()};
  auto store = Store::open(url->server);
  if (!store) return tl::unexpected{store.error()};
  if (auto done = store->begin_log(url->name, *interface); !done) return done;
  const auto frames = upload(*store, url->name, **log);
  if (!frames) {
    (void)store->remove(url->name);  // half a log is none; why it is only half is what counts
    return tl::unexpected{frames.error()};
  }
  tell(fmt::format("{} frames of {} are in {}", *frames, *interface, url->name));
  return {};
}

}  // namespace

void add_import(CLI::App& app, Run& run) {
  CLI::App& sub = subcommand(app, "import", "Make a recording of a log of candump");
  const auto words = std::make_shared<ImportWords>();
  sub.add_option("FILE", words->log.path, "Log as candump -l writes it")->required();
  sub.add_option("URL", words->url, "nats://HOST[:PORT]/RECORDING or tls://...")->required()->type_name("");
  sub.add_option("--interface", words->log.interface, "the frames of this interface, if the log has several")
      ->type_name("NAME");
  sub.add_flag("--skip-damaged", words->log.skip_damaged, "leave lines out that are damaged");
  sub.callback([&run, words] {
    run = [words](const nats::ServerOptions& options) { return import_log(*words, options); };
  });
}

}  // namespace canrec
