#include "cli/completion.hpp"
#include "cli/script_tables.hpp"

namespace cli {
namespace {

// The words before the one that is completed say where it stands: `path` is the subcommand, `place` counts words,
// `pending` is the option whose value is awaited.
constexpr const char* kScript = R"script(# bash completion for @PROGRAM@
@FUNCTION@() {
  local -A commands=(
@COMMANDS@  )
  local -A options=(
@OPTIONS@  )
  local -A values=(
@VALUES@  )
  local -A words=(
@WORDS@  )
  local cur=${COMP_WORDS[COMP_CWORD]} path='@PROGRAM@' pending= only= offered= spec= above word name
  local -i i place=0
  for ((i = 1; i < COMP_CWORD; i++)); do
    word=${COMP_WORDS[i]}
    if [[ $word == '=' ]]; then continue; fi
    if [[ -n $pending ]]; then pending=; continue; fi
    if [[ $word == '--' && -z $only ]]; then only=words; continue; fi
    if [[ $word == -?* && -z $only ]]; then
      above=$path
      while :; do
        if [[ -n ${values[$above $word]-} ]]; then pending=${values[$above $word]}; break; fi
        [[ $above == *' '* ]] || break
        above=${above% *}
      done
    elif [[ " ${commands[$path]-} " == *" $word "* ]]; then
      path+=" $word"; place=0
    else
      place+=1
      if [[ ${words[$path $place]-${words[$path *]-}} == '@command' ]]; then
        if declare -F _command_offset > /dev/null; then _command_offset "$i"; else COMPREPLY=($(compgen -f -- "$cur")); fi
        return
      fi
    fi
  done
  if [[ $cur == '=' ]]; then cur=; fi
  if [[ -n $pending ]]; then
    spec=$pending
  elif [[ $cur == -* && -z $only ]]; then
    above=$path
    while :; do
      offered+=" ${options[$above]-}"
      [[ $above == *' '* ]] || break
      above=${above% *}
    done
    spec=$offered
  else
    name=$path
    place+=1
    spec="${commands[$path]-} ${words[$name $place]-${words[$name *]-}}"
  fi
  COMPREPLY=()
  for word in $spec; do
    case $word in
      @none) ;;
      @file) compopt -o filenames 2> /dev/null; COMPREPLY+=($(compgen -f -- "$cur")) ;;
      @folder) compopt -o filenames 2> /dev/null; COMPREPLY+=($(compgen -d -- "$cur")) ;;
      @interface) COMPREPLY+=($(compgen -W "$(ls /sys/class/net 2> /dev/null)" -- "$cur")) ;;
      @unit) COMPREPLY+=($(compgen -W "$(axisctl --brief units 2> /dev/null | cut -d ' ' -f 1)" -- "$cur")) ;;
      @command) COMPREPLY+=($(compgen -c -- "$cur")) ;;
      *) [[ $word == "$cur"* && " ${COMPREPLY[*]} " != *" $word "* ]] && COMPREPLY+=("$word") ;;
    esac
  done
}
complete -F @FUNCTION@ @PROGRAM@
)script";

}  // namespace

std::string bash_script(const Command& program) {
  return filled(kScript, program);
}

}  // namespace cli
