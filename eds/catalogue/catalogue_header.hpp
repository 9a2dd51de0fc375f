#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "eds/catalogue/catalogue.hpp"

namespace eds {

/// Reads the header of a catalogue; throws CatalogueError, as all of these.
[[nodiscard]] Header read_header(const nlohmann::json& json);

/// Reads the list of EDS files; every name stands once.
[[nodiscard]] std::vector<EdsFile> read_files(const nlohmann::json& json);

/// Reads the list of axis offsets: ranges of axis 1, ascending, that do not reach into those of axis 2.
[[nodiscard]] std::vector<AxisOffset> read_axis_offsets(const nlohmann::json& json);

}  // namespace eds
