#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/completion.hpp"
#include "cli/script_tables.hpp"

namespace cli {
namespace {

// Says to which subcommand the words so far lead.
constexpr const char* kHead = R"script(# fish completion for @PROGRAM@
function _@FUNCTION@_path
    set -l path '@PROGRAM@'
    for word in (commandline -opc)[2..-1]
        if contains -- "$path $word" @PATHS@
            set path "$path $word"
        end
    end
    echo $path
end
complete -c @PROGRAM@ -f
)script";

/// What `complete -a` takes for @p value; empty: nothing.
std::string arguments_of(const Value& value) {
  switch (value.kind) {
    case Kind::Nothing:
      return "";
    case Kind::Choices:
      return fmt::format("-a {}", quoted(fmt::format("{}", fmt::join(value.choices, " "))));
    case Kind::File:
      return "-F";
    case Kind::Folder:
      return "-a '(__fish_complete_directories)'";
    case Kind::Interface:
      return "-a '(ls /sys/class/net)'";
    case Kind::Unit:
      return R"(-a '(axisctl --brief units 2> /dev/null | string replace -r " .*" "")')";
    case Kind::Command:
      break;
  }
  return "-a '(__fish_complete_subcommand)'";
}

std::string option_line(const Command& program, const std::string& condition, const Option& option) {
  std::string line = fmt::format("complete -c {} {}", program.name, condition);
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (option.takes_value) line += option.value.kind == Kind::File ? " -r " : " -x ";
  if (option.takes_value) line += arguments_of(option.value);
  return line + fmt::format(" -d {}\n", quoted(option.help));
}

}  // namespace

std::string fish_script(const Command& program) {
  std::string paths;
  std::string lines;
  const std::string function = function_of(program);
  visit_commands(program, [&](const std::string& path, const Command& command) {
    if (path != program.name) paths += (paths.empty() ? "" : " ") + quoted(path);
    const std::string here = fmt::format("-n 'test (_{}_path) = \"{}\"'", function, path);
    const std::string below = fmt::format("-n 'string match -q -- \"{}*\" (_{}_path)'", path, function);
    for (const Command& sub : command.commands)
      lines += fmt::format("complete -c {} {} -a {} -d {}\n", program.name, here, sub.name, quoted(sub.help));
    for (const Option& option : command.options) lines += option_line(program, below, option);
    for (const Word& word : command.words)
      if (const std::string arguments = arguments_of(word.value); !arguments.empty())
        lines += fmt::format("complete -c {} {} {}\n", program.name, here, arguments);
  });
  std::string head = filled(kHead, program);
  const std::string place = "@PATHS@";
  head.replace(head.find(place), place.size(), paths.empty() ? "''" : paths);
  return head + lines;
}

}  // namespace cli
