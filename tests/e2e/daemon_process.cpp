#include "tests/e2e/daemon_process.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "tests/e2e/test_bus.hpp"

namespace e2e {
namespace {

std::string configuration_of(const DaemonOptions& options, const std::string& path) {
  if (options.axis.is_null()) return "";
  nlohmann::json configuration{{"axes", nlohmann::json::array({options.axis})}};
  if (!options.supply.is_null()) configuration["supply"] = options.supply;
  if (!options.infeed.is_null()) configuration["infeed"] = options.infeed;
  std::ofstream{path} << configuration;
  return path;
}

}  // namespace

DaemonProcess::DaemonProcess(DaemonOptions options)
    : notify_{folder_.path("notify.sock")}, options_{std::move(options)} {
  start();
}

void DaemonProcess::start() {
  std::vector<std::string> environment = options_.environment;
  environment.push_back(notify_.environment());
  program_ = std::make_unique<Program>(arguments(), environment);
}

std::vector<std::string> DaemonProcess::arguments() const {
  std::vector<std::string> words{AXISD_PROGRAM,
                                 "--interface",
                                 options_.interface,
                                 "--node-id",
                                 std::to_string(options_.node_id),
                                 "--axes",
                                 std::to_string(options_.axes)};
  const std::string state = options_.state_directory.empty() ? folder_.path("state") : options_.state_directory;
  words.insert(words.end(), {"--state-directory", state, "--control", control_socket()});
  if (!options_.motor.is_null()) std::ofstream{folder_.path("motor.json")} << options_.motor;
  const std::string file = configuration_of(options_, folder_.path("axisd.json"));
  if (!file.empty()) words.insert(words.end(), {"--config", file});
  return words;
}

testing::AssertionResult DaemonProcess::is_ready() {
  if (notify_.wait_for("READY=1")) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "axisd is not ready; it wrote:\n" << program_->output();
}

int DaemonProcess::end(int signal) {
  program_->signal(signal);
  return program_->wait();
}

std::size_t DaemonProcess::log_lines(const std::string& text) {
  std::istringstream log{program_->output()};
  std::size_t count = 0;
  for (std::string line; std::getline(log, line);) count += line.find(text) != std::string::npos ? 1U : 0U;
  return count;
}

fakes::Finished DaemonProcess::axisctl(std::vector<std::string> words) const {
  words.insert(words.begin(), {AXISCTL_PROGRAM, "--socket", control_socket()});
  return fakes::run_program(words, bus_environment());
}

nlohmann::json DaemonProcess::status() const {
  const fakes::Finished finished = axisctl({"--json", "status"});
  if (finished.status != 0) throw std::runtime_error{"axisctl: " + finished.errors};
  return nlohmann::json::parse(finished.output);
}

fakes::Finished run_axisd(std::vector<std::string> words) {
  words.insert(words.begin(), AXISD_PROGRAM);
  return fakes::run_program(words);
}

}  // namespace e2e
