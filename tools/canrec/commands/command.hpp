#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "can/nats/url.hpp"
#include "can/nats_options/nats_options.hpp"
#include "tools/canrec/frames/failure.hpp"

namespace CLI {
class App;
}

namespace canrec {

/// What the chosen subcommand does; @p options say how a server is spoken to.
using Run = std::function<Expected<void>(const nats::ServerOptions& options)>;

/// Adds a subcommand with its words and options to the command line; chosen, it puts what it does into @p run.
using AddCommand = void (*)(CLI::App& app, Run& run);

/// All of them, in the order of the help.
[[nodiscard]] std::span<const AddCommand> commands() noexcept;

void add_record(CLI::App& app, Run& run);
void add_stop(CLI::App& app, Run& run);
void add_list(CLI::App& app, Run& run);
void add_remove(CLI::App& app, Run& run);
void add_export(CLI::App& app, Run& run);
void add_import(CLI::App& app, Run& run);
void add_play(CLI::App& app, Run& run);

/// A subcommand that takes the options of the program as well.
CLI::App& subcommand(CLI::App& app, const std::string& name, const std::string& description);

/// The server that @p text, of the form `nats://HOST[:PORT]/WHAT`, leads to, spoken to as @p options say; and the
/// name there. An empty @p what: without one.
[[nodiscard]] Expected<nats::Url> read_url(std::string_view text, std::string_view what,
                                           const nats::ServerOptions& options);

/// Writes @p line, behind the name of the program, to standard error.
void tell(std::string_view line);

}  // namespace canrec
