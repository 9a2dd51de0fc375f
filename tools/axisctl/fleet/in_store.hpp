#pragma once

#include <functional>
#include <string>
#include <utility>

#include "farm/mirror/mirror_thread.hpp"
#include "farm/naming/unit_name.hpp"
#include "tools/axisctl/commands/command.hpp"

namespace fleet {

/// Has @p job done with what the server of the farm of @p settings keeps, and waits.
template <class Result, class Job>
[[nodiscard]] axisctl::Expected<Result> in_store(const axisctl::Settings& settings, Job job) {
  auto result = settings.farm->store<Result>(std::move(job));
  if (!result) return axisctl::fail(axisctl::ExitStatus::NotReachable, result.error());
  return *std::move(result);
}

/// The unit that @p word, "BUS/NODE", names.
[[nodiscard]] axisctl::Expected<farm::UnitName> unit_of(const std::string& word);
/// That @p word can be the name of a host.
[[nodiscard]] axisctl::Expected<void> expect_host(const std::string& word);

}  // namespace fleet
