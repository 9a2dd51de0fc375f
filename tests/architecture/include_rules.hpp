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
  std::array<std::string_view, 14> allowed;  ///< empty items allow nothing
};

/// Headers of Linux and of the C library: in angle brackets, ended by .h, of no library that is named in a layer.
inline constexpr std::string_view kSystem = "<*.h>";

/// Who may include whom: a folder rests only on what its row names.
inline constexpr std::array kLayers{
    Layer{"os", {"fmt/", kSystem}},
    Layer{"control", {"fmt/", "nlohmann/", kSystem}},
    Layer{"libcanopen", {}},
    Layer{"motor", {"Eigen/", "unsupported/Eigen/"}},
    Layer{"drive", {"motor/", "fmt/"}},
    Layer{"device", {"libcanopen/", "drive/", "fmt/", "generated/object_table.hpp"}},
    Layer{"eds", {"libcanopen/od/", "nlohmann/", "fmt/"}},
    Layer{"userbus", {kSystem}},
    Layer{"bus",
          {"libcanopen/base/frame.hpp", "libcanopen/base/time.hpp", "os/", "userbus/", "nlohmann/", "fmt/",
           kSystem}},
    Layer{"hub", {"libcanopen/base/", "os/", "userbus/", "bus/", "fmt/", kSystem}},
    Layer{"daemon/base",
          {"libcanopen/base/time.hpp", "os/", "bus/message_limit.hpp", "fmt/", "systemd/", kSystem}},
    Layer{"daemon/configuration", {"motor/", "drive/", "bus/address.hpp", "fmt/", "nlohmann/"}},
    Layer{"daemon/instance",
          {"daemon/base/", "daemon/configuration/", "daemon/version.hpp", "libcanopen/", "drive/", "motor/",
           "device/", "os/", "bus/", "fmt/", "nlohmann/", kSystem}},
    Layer{"daemon/program",
          {"daemon/", "control/", "libcanopen/", "drive/", "motor/", "device/", "os/", "bus/", "fmt/", "CLI/",
           "systemd/", "nlohmann/", kSystem}},
    Layer{"tools",
          {"libcanopen/", "eds/", "os/", "userbus/", "bus/", "hub/", "control/", "fmt/", "nlohmann/", "CLI/",
           kSystem}},
    Layer{"preload", {"userbus/", kSystem}},
};

/// Checks every source file of the folders of @p layers below @p root; a message for every include that breaks a
/// rule: "drive/axis.cpp:3: drive may not include libcanopen/base/frame.hpp".
std::vector<std::string> find_forbidden_includes(const std::filesystem::path& root, std::span<const Layer> layers);

}  // namespace architecture
