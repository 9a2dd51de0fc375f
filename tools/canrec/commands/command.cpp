#include "tools/canrec/commands/command.hpp"

#include <array>
#include <iostream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace canrec {

std::span<const AddCommand> commands() noexcept {
  static constexpr std::array<AddCommand, 7> kCommands{add_record, add_stop,   add_list, add_remove,
                                                       add_export, add_import, add_play};
  return kCommands;
}

CLI::App& subcommand(CLI::App& app, const std::string& name, const std::string& description) {
  CLI::App* const sub = app.add_subcommand(name, description);
  sub->fallthrough();
  return *sub;
}

Expected<nats::Url> read_url(std::string_view text, std::string_view what, const nats::ServerOptions& options) {
  auto url = nats::parse_url(text, what);
  if (!url) return fail(Status::Usage, fmt::format("{}, got \"{}\"", url.error(), text));
  if (auto done = nats::secure(url->server, url->host, options); !done) return fail(Status::Usage, done.error());
  return *std::move(url);
}

void tell(std::string_view line) {
  std::cerr << "canrec: " << line << std::endl;
}

}  // namespace canrec
