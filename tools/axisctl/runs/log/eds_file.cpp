#include "tools/axisctl/runs/log/eds_file.hpp"

#include <fmt/format.h>

#include "tools/sheet_file.hpp"

namespace runs {

axisctl::Expected<eds::Description> read_eds(const std::string& path, std::uint8_t node) {
  if (path.empty()) return eds::Description{};
  const auto text = tools::read_sheet_file(path);
  if (!text) return axisctl::fail(axisctl::ExitStatus::NotThere, text.error());
  eds::Description description = eds::read_description(*text, path, node);
  if (description.empty())
    return axisctl::fail(axisctl::ExitStatus::Usage, fmt::format("--eds: {}: there is no object in it", path));
  return description;
}

}  // namespace runs
