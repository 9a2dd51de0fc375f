// A configuration a line of standard input; for each the verdict of the reader, a line too: "accepted", or its
// message. It answers before it reads the next one.
#include <iostream>
#include <string>

#include "daemon/configuration/configuration.hpp"
#include "daemon/program/motor_folders.hpp"

int main() {
  const axisd::MotorFolders motors;
  for (std::string line; std::getline(std::cin, line);) {
    try {
      static_cast<void>(axisd::parse_configuration(line, "node.json", motors));
      std::cout << "accepted" << std::endl;
    } catch (const axisd::ConfigurationError& error) {
      std::cout << error.what() << std::endl;
    }
  }
}
