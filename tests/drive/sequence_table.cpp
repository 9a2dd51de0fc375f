#include "tests/drive/sequence_table.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace drive {
namespace {

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream in{line};
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

/// Words 1 to 4 as 16 symbols.
std::string symbols(const std::vector<std::string>& words) {
  std::string all;
  for (std::size_t i = 1; i < words.size(); ++i) all += words[i];
  if (words.size() != 5 || all.size() != 16) throw std::runtime_error{"expected a name and four times four bits"};
  return all;
}

SequenceTable::Pattern pattern(const std::string& bits) {
  SequenceTable::Pattern result;
  for (std::size_t i = 0; i < bits.size(); ++i) {
    const auto bit = static_cast<std::uint16_t>(1U << (15U - i));
    if (bits[i] == '.') continue;
    if (bits[i] != '0' && bits[i] != '1') throw std::runtime_error{"expected 0, 1 or . as a bit"};
    result.mask = static_cast<std::uint16_t>(result.mask | bit);
    if (bits[i] == '1') result.value = static_cast<std::uint16_t>(result.value | bit);
  }
  return result;
}

SequenceTable::Row row(const std::vector<std::string>& words) {
  if (words.size() != 5) throw std::runtime_error{"expected state, shaft, condition, command and next state"};
  const auto& states = states_by_name();
  return {states.at(words[0]), words[1] != "turning", words[1] != "still", words[2] == "free", words[3],
          states.at(words[4])};
}

void take(SequenceTable& table, const std::string& section, const std::vector<std::string>& words) {
  if (section == "[commands]") table.commands.emplace(words[0], pattern(symbols(words)));
  if (section == "[halt_commands]") table.halt_commands.emplace(words[0], pattern(symbols(words)));
  if (section == "[transitions]") table.rows.push_back(row(words));
  if (section == "[statuswords]") table.statuswords[states_by_name().at(words[0])] = symbols(words);
}

}  // namespace

const std::map<std::string, State>& states_by_name() {
  using enum State;
  static const std::map<std::string, State> states{{"not_ready", NotReadyToSwitchOn},
                                                   {"disabled", SwitchOnDisabled},
                                                   {"ready", ReadyToSwitchOn},
                                                   {"switched_on", SwitchedOn},
                                                   {"enabled", OperationEnabled},
                                                   {"off1_braking", Off1Braking},
                                                   {"quick_stop", QuickStopActive},
                                                   {"reaction", FaultReactionActive},
                                                   {"stop2", Stop2Active},
                                                   {"fault", Fault}};
  return states;
}

SequenceTable::Pattern SequenceTable::statusword(State state, bool still, std::uint16_t controlword) const {
  std::string bits = statuswords.at(state);
  for (char& bit : bits) {
    if (bit == 's') bit = still ? '1' : '0';
    if (bit == 't') bit = still ? '1' : '.';
    if (bit == 'v') bit = (controlword & 0x0002) != 0 ? '1' : '0';
    if (bit == 'q') bit = (controlword & 0x0004) != 0 ? '1' : '0';
  }
  return pattern(bits);
}

SequenceTable read_sequence_table() {
  const std::string path = std::string{SOURCE_FOLDER} + "/tests/data/sequence_control.txt";
  std::ifstream file{path};
  if (!file) throw std::runtime_error{path + ": cannot be read"};
  SequenceTable table;
  std::string section;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    if (line.front() == '[') {
      section = line;
      continue;
    }
    try {
      take(table, section, words_of(line));
    } catch (const std::exception& error) {
      throw std::runtime_error{path + ":" + std::to_string(number) + ": " + error.what()};
    }
  }
  return table;
}

}  // namespace drive
