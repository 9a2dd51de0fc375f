#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace architecture {

/// What a folder may include besides itself, the standard library and tl/expected.hpp.
/// An item that ends with a slash allows what lies below it; kSystem allows headers of Linux and of the C library.
struct Layer {
  std::string_view folder;
  std::array<std::string_view, 12> allowed;  ///< empty items allow nothing
};

/// Headers of Linux and of the C library: in angle brackets, ended by .h, of no library that is named in a layer.
inline constexpr std::string_view kSystem = "<*.h>";

/// Who may include whom: a folder rests only on what its row names.
inline constexpr std::array kLayers{
    Layer{"libcanopen", {}},
    Layer{"motor", {"Eigen/", "unsupported/Eigen/"}},
    Layer{"drive", {"motor/", "fmt/"}},
    Layer{"unit", {"drive/"}},
    Layer{"device",
          {"libcanopen/", "drive/", "unit/", "fmt/", "generated/object_table.hpp", "generated/axis_offsets.hpp",
           "eds/axis_rule.hpp"}},
    Layer{"eds", {"libcanopen/od/", "nlohmann/", "fmt/"}},
    Layer{"userbus", {kSystem}},
    Layer{"bus",
          {"libcanopen/base/frame.hpp", "libcanopen/base/time.hpp", "userbus/", "nlohmann/", "fmt/", kSystem}},
    Layer{"hub", {"libcanopen/base/", "userbus/", "bus/", "fmt/", kSystem}},
    Layer{"daemon",
          {"libcanopen/", "drive/", "motor/", "unit/", "device/", "eds/", "bus/", "fmt/", "nlohmann/", "CLI/", "systemd/",
           kSystem}},
    Layer{"tools",
          {"libcanopen/", "eds/", "userbus/", "bus/", "hub/", "daemon/control_protocol.hpp", "fmt/", "nlohmann/",
           "CLI/", kSystem}},
    Layer{"preload", {"userbus/", kSystem}},
};

/// Folders that may include everything.
inline constexpr std::array<std::string_view, 3> kOutside{"bench", "examples", "tests"};

/// Checks every source file of the folders of @p layers below @p root; a message for every include that breaks a
/// rule: "drive/axis.cpp:3: drive may not include libcanopen/base/frame.hpp".
std::vector<std::string> find_forbidden_includes(const std::filesystem::path& root, std::span<const Layer> layers);

/// Where @p layers and the source files below @p root do not fit together: a message for every file that no layer
/// has a rule for, but those of kOutside, and for every layer without a file.
std::vector<std::string> find_lawless(const std::filesystem::path& root, std::span<const Layer> layers);

}  // namespace architecture
