// A configuration a line of standard input; for each the verdict of the reader, a line too: "accepted", or its
// message.
#include <iostream>
#include <string>

#include "daemon/configuration/configuration.hpp"
#include "daemon/program/motor_folders.hpp"

int main() {
  const axisd::MotorFolders motors;
  for (std::string line; std::getline(std::cin, line);) {
    try {
      static_cast<void>(axisd::parse_configuration(line, "node.json", motors));
      std::cout << "accepted\n";
    } catch (const axisd::ConfigurationError& error) {
      std::cout << error.what() << '\n';
    }
  }
}
