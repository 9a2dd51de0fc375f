#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "record/candump.hpp"
#include "tools/canrec/commands/command.hpp"
#include "tools/canrec/commands/output.hpp"
#include "tools/canrec/server/recording_frames.hpp"

namespace canrec {

namespace {

struct ExportWords {
  std::string url;
  std::string file;
  std::string interface;
};

Expected<void> write_all(RecordingFrames& frames, const std::string& interface, Output& output) {
  for (;;) {
    const auto frame = frames.next();
    if (!frame) return tl::unexpected{frame.error()};
    if (!*frame) return output.finish();
    const record::CandumpLine line{.at = (*frame)->at, .interface = interface, .frame = (*frame)->frame};
    if (auto done = output.write(record::candump_line(line)); !done) return done;
  }
}

Expected<void> export_log(const ExportWords& words, const nats::ServerOptions& options) {
  const auto url = read_url(words.url, "RECORDING", options);
  if (!url) return tl::unexpected{url.error()};
  auto store = Store::open(url->server);
  if (!store) return tl::unexpected{store.error()};
  const auto recording = store->find(url->name);
  if (!recording) return tl::unexpected{recording.error()};
  auto messages = Messages::open(*store, *recording);
  if (!messages) return tl::unexpected{messages.error()};
  auto output = Output::open(words.file);
  if (!output) return tl::unexpected{output.error()};
  RecordingFrames frames{*std::move(messages)};
  auto done = write_all(frames, words.interface.empty() ? recording->bus : words.interface, *output);
  if (done) tell(frames.transcript().text());
  return done;
}

}  // namespace

void add_export(CLI::App& app, Run& run) {
  CLI::App& sub = subcommand(app, "export", "Write the frames of a recording as candump -L does");
  const auto words = std::make_shared<ExportWords>();
  sub.add_option("URL", words->url, "nats://HOST[:PORT]/RECORDING or tls://...")->required()->type_name("");
  sub.add_option("FILE", words->file, "Where to (default: -, standard output)");
  sub.add_option("--interface", words->interface, "name in the log (default: that of the bus)")->type_name("NAME");
  sub.callback([&run, words] {
    run = [words](const nats::ServerOptions& options) { return export_log(*words, options); };
  });
}

}  // namespace canrec
