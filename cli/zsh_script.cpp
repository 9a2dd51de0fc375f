#include "cli/completion.hpp"
#include "cli/script_tables.hpp"

namespace cli {
namespace {

// As in bash, with the words of zsh, which count from 1.
constexpr const char* kScript = R"script(#compdef @PROGRAM@
@FUNCTION@() {
  local -A commands_of options_of values_of words_of
  commands_of=(
@COMMANDS@  )
  options_of=(
@OPTIONS@  )
  values_of=(
@VALUES@  )
  words_of=(
@WORDS@  )
  local way='@PROGRAM@' pending='' only='' spec='' above word
  local -i i place=0
  for ((i = 2; i < CURRENT; i++)); do
    word=${words[i]}
    if [[ -n $pending ]]; then pending=''; continue; fi
    if [[ $word == '--' && -z $only ]]; then only=words; continue; fi
    if [[ $word == -?* && -z $only ]]; then
      above=$way
      while true; do
        if [[ -n ${values_of[$above $word]} ]]; then pending=${values_of[$above $word]}; break; fi
        [[ $above == *' '* ]] || break
        above=${above% *}
      done
    elif [[ " ${commands_of[$way]} " == *" $word "* ]]; then
      way+=" $word"; place=0
    else
      place+=1
      if [[ ${words_of[$way $place]:-${words_of[$way *]}} == '@command' ]]; then
        shift $((i - 1)) words
        CURRENT=$((CURRENT - i + 1))
        _normal
        return
      fi
    fi
  done
  if [[ -n $pending ]]; then
    spec=$pending
  elif [[ $PREFIX == -* && -z $only ]]; then
    above=$way
    while true; do
      spec+=" ${options_of[$above]}"
      [[ $above == *' '* ]] || break
      above=${above% *}
    done
  else
    place+=1
    spec="${commands_of[$way]} ${words_of[$way $place]:-${words_of[$way *]}}"
  fi
  for word in ${=spec}; do
    case $word in
      @none) ;;
      @file) _files ;;
      @folder) _files -/ ;;
      @interface) compadd -- /sys/class/net/*(N:t) ;;
      @unit) compadd -- ${${(f)"$(axisctl --brief units 2> /dev/null)"}%% *} ;;
      @command) _command_names ;;
      *) compadd -- $word ;;
    esac
  done
}
@FUNCTION@ "$@"
)script";

/// In zsh a key stands between double quotes too: the brackets of its arrays take quotes as part of the key.
std::string without_brackets(std::string script) {
  for (std::size_t at = script.find("    ['"); at != std::string::npos; at = script.find("    ['", at)) {
    script.replace(at, 6, "    '");
    const std::size_t end = script.find("']=", at);
    script.replace(end, 3, "' ");
  }
  return script;
}

}  // namespace

std::string zsh_script(const Command& program) {
  return without_brackets(filled(kScript, program));
}

}  // namespace cli
