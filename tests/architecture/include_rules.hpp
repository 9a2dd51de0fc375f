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
  std::array<std::string_view, 24> allowed;  ///< empty items allow nothing
};

/// Headers of Linux and of the C library: in angle brackets, ended by .h, of no library that is named in a layer.
inline constexpr std::string_view kSystem = "<*.h>";

/// Who may include whom: a folder rests only on what its row names.
inline constexpr std::array kLayers{
    Layer{"os", {"fmt/", kSystem}},
    Layer{"version", {"generated/version.hpp", "fmt/"}},
    Layer{"control", {"fmt/", "nlohmann/", "generated/control_methods.hpp", kSystem}},
    Layer{"cli", {"fmt/", "CLI/"}},
    Layer{"libcanopen", {}},
    Layer{"libcanopen/base", {}},
    Layer{"libcanopen/od", {"libcanopen/base/"}},
    Layer{"libcanopen/application", {"libcanopen/base/", "libcanopen/od/"}},
    Layer{"libcanopen/service", {"libcanopen/base/", "libcanopen/od/", "libcanopen/application/"}},
    Layer{"libcanopen/nmt", {"libcanopen/base/", "libcanopen/od/", "libcanopen/service/"}},
    Layer{"libcanopen/sdo", {"libcanopen/base/", "libcanopen/od/", "libcanopen/service/"}},
    Layer{"libcanopen/pdo", {"libcanopen/base/", "libcanopen/od/", "libcanopen/service/", "libcanopen/sync/"}},
    Layer{"libcanopen/sync", {"libcanopen/base/", "libcanopen/od/", "libcanopen/service/"}},
    Layer{"libcanopen/time", {"libcanopen/base/", "libcanopen/od/", "libcanopen/service/"}},
    Layer{"libcanopen/emcy", {"libcanopen/base/", "libcanopen/od/", "libcanopen/service/"}},
    Layer{"libcanopen/storage", {"libcanopen/base/", "libcanopen/od/", "libcanopen/service/"}},
    Layer{"libcanopen/node", {"libcanopen/"}},
    Layer{"text", {}},
    Layer{"json", {"nlohmann/", "fmt/"}},
    Layer{"checksum", {}},
    Layer{"motor", {"Eigen/", "unsupported/Eigen/"}},
    Layer{"motor/math", {}},
    Layer{"motor/data", {"motor/math/"}},
    Layer{"motor/plant", {"Eigen/", "unsupported/Eigen/", "motor/math/", "motor/data/"}},
    Layer{"motor/control", {"motor/math/", "motor/data/", "motor/plant/"}},
    Layer{"motor/identification", {"Eigen/", "motor/math/", "motor/data/", "motor/plant/", "motor/control/"}},
    Layer{"drive", {"motor/", "text/", "checksum/", "fmt/"}},
    Layer{"drive/base", {"motor/data/"}},
    Layer{"drive/parameter", {"motor/data/", "text/", "fmt/", "drive/base/"}},
    Layer{"drive/machine", {"motor/data/", "motor/control/"}},
    Layer{"drive/values", {"motor/control/", "drive/base/", "drive/parameter/", "drive/machine/"}},
    Layer{"drive/messages", {"fmt/", "drive/base/"}},
    Layer{"unit", {"drive/"}},
    Layer{"profidrive", {"drive/", "unit/", "fmt/"}},
    Layer{"modbus", {"profidrive/", "unit/", "drive/"}},
    Layer{"trace", {"motor/", "drive/", "unit/", "text/", "fmt/", "nlohmann/"}},
    Layer{"trace/export", {"nlohmann/", "fmt/"}},
    Layer{"trace/signal", {"motor/", "drive/", "unit/", "text/", "fmt/"}},
    Layer{"device",
          {"libcanopen/", "drive/", "unit/", "fmt/", "generated/object_table.hpp", "generated/axis_offsets.hpp",
           "eds/catalogue/axis_rule.hpp"}},
    Layer{"eds", {"libcanopen/od/", "text/", "nlohmann/", "fmt/"}},
    Layer{"injection", {"libcanopen/", "drive/", "unit/", "device/", "text/", "nlohmann/", "fmt/"}},
    Layer{"injection/language", {"libcanopen/base/time.hpp", "text/", "fmt/"}},
    Layer{"injection/kinds", {"injection/language/"}},
    Layer{"injection/json", {"injection/language/", "text/", "nlohmann/", "fmt/"}},
    Layer{"can/userbus", {kSystem}},
    Layer{"can/port",
          {"libcanopen/base/frame.hpp", "libcanopen/base/time.hpp", "os/", "can/userbus/", "text/", "nlohmann/",
           "fmt/", kSystem}},
    Layer{"can/connection", {"libcanopen/base/frame.hpp", "libcanopen/base/time.hpp", "os/", "can/port/", "fmt/"}},
    Layer{"can/bus_faults", {"can/userbus/", "os/", "nlohmann/", "fmt/", kSystem}},
    Layer{"can/hub",
          {"libcanopen/base/", "os/", "can/userbus/", "can/port/", "can/connection/", "injection/language/",
           "injection/kinds/", "injection/json/", "nlohmann/", "fmt/", kSystem}},
    Layer{"record",
          {"libcanopen/base/frame.hpp", "libcanopen/base/time.hpp", "checksum/", "os/", "text/", "fmt/",
           "nlohmann/", kSystem}},
    Layer{"service",
          {"libcanopen/base/time.hpp", "os/", "can/connection/message_limit.hpp", "fmt/", "systemd/", kSystem}},
    Layer{"daemon/base", {"os/", "fmt/", kSystem}},
    Layer{"daemon/configuration",
          {"motor/", "drive/", "can/port/address.hpp", "record/format.hpp", "trace/settings.hpp", "trace/json/",
           "json/", "injection/language/", "injection/kinds/", "injection/json/", "text/", "fmt/", "nlohmann/"}},
    Layer{"daemon/modbus",
          {"service/", "daemon/base/", "daemon/configuration/settings/modbus_settings.hpp", "modbus/", "os/",
           "fmt/", kSystem}},
    Layer{"daemon/watch",
          {"service/", "daemon/base/", "daemon/configuration/", "version/", "libcanopen/", "drive/", "unit/",
           "device/", "can/port/", "record/", "trace/", "os/", "fmt/", "nlohmann/", kSystem}},
    Layer{"daemon/instance",
          {"injection/",     "service/",  "daemon/base/", "daemon/watch/",   "daemon/configuration/",
           "record/",        "trace/",    "version/",     "libcanopen/",     "drive/",
           "motor/",         "unit/",     "device/",      "profidrive/",     "modbus/",
           "daemon/modbus/", "os/",       "can/port/",    "can/connection/", "text/",
           "fmt/",           "nlohmann/", kSystem}},
    Layer{"daemon/control",
          {"injection/", "service/", "daemon/base/", "daemon/watch/", "daemon/instance/", "daemon/configuration/",
           "version/",   "control/", "record/",      "trace/",        "device/",          "profidrive/",
           "modbus/",    "unit/",    "drive/",       "motor/",        "libcanopen/",      "can/",
           "text/",      "fmt/",     "nlohmann/"}},
    Layer{"daemon/loop", {"service/", "daemon/base/", "daemon/instance/", "libcanopen/base/", "os/", kSystem}},
    Layer{"daemon/fleet",
          {"service/", "daemon/base/", "daemon/configuration/", "daemon/instance/", "daemon/loop/",
           "control/error.hpp", "can/port/", "os/", "fmt/", kSystem}},
    Layer{"daemon/server",
          {"service/", "daemon/base/", "daemon/configuration/", "daemon/watch/", "daemon/control/",
           "daemon/fleet/", "record/event.hpp", "control/", "os/", "fmt/", "nlohmann/", "systemd/", kSystem}},
    Layer{"daemon/program",
          {"cli/", "version/", "service/", "daemon/", "control/", "libcanopen/", "drive/", "motor/", "unit/",
           "device/", "os/", "can/port/", "can/connection/", "text/", "fmt/", "CLI/", "systemd/", "nlohmann/",
           kSystem}},
    Layer{"gateway/base", {"control/", "text/", "fmt/", "nlohmann/"}},
    Layer{"gateway/security", {"gateway/base/", "os/", "text/", "fmt/", "nlohmann/", kSystem}},
    Layer{"gateway/routes", {"gateway/base/", "control/", "text/", "fmt/", "nlohmann/"}},
    Layer{"gateway/server",
          {"gateway/base/", "gateway/security/", "service/", "os/", "microhttpd.h", "fmt/", "nlohmann/", kSystem}},
    Layer{"gateway/page", {"gateway/base/", "gateway/server/", "checksum/", "os/", "fmt/"}},
    Layer{"gateway/units",
          {"gateway/base/", "control/", "service/", "os/", "fmt/", "nlohmann/", "systemd/", kSystem}},
    Layer{"gateway/streams",
          {"gateway/base/", "gateway/routes/", "gateway/server/", "gateway/units/", "control/methods.hpp",
           "service/", "os/clock.hpp", "fmt/", "nlohmann/", "systemd/"}},
    Layer{"gateway/live",
          {"gateway/base/", "gateway/routes/", "gateway/server/", "gateway/units/", "gateway/streams/", "service/",
           "os/clock.hpp", "text/", "fmt/", "nlohmann/", "systemd/"}},
    Layer{"gateway/openapi", {"gateway/base/", "gateway/routes/", "control/", "fmt/", "nlohmann/"}},
    Layer{"gateway/api",
          {"gateway/base/", "gateway/security/", "gateway/routes/", "gateway/server/", "gateway/units/",
           "gateway/streams/", "gateway/page/", "gateway/live/", "gateway/openapi/document.hpp",
           "gateway/metrics/", "control/error.hpp", "version/", "os/", "text/", "fmt/", "nlohmann/", kSystem}},
    Layer{"gateway/program",
          {"gateway/", "service/", "cli/", "version/", "control/", "os/", "libcanopen/base/time.hpp", "CLI/",
           "fmt/", "nlohmann/", "systemd/", kSystem}},
    Layer{"gateway/metrics", {"fmt/", "nlohmann/"}},
    Layer{"tools",
          {"libcanopen/",
           "eds/",
           "os/",
           "can/userbus/",
           "can/bus_faults/",
           "can/port/",
           "can/connection/",
           "can/hub/",
           "text/",
           "control/",
           "record/",
           "trace/export/",
           "injection/language/",
           "injection/kinds/",
           "injection/json/",
           "json/",
           "cli/",
           "version/",
           "fmt/",
           "nlohmann/",
           "CLI/",
           kSystem}},
    Layer{"man", {"cli/scdoc_text.hpp", "fmt/", "nlohmann/"}},
    Layer{"testing", {"axisd/testing/", "gtest/", "nlohmann/", kSystem}},
    Layer{"can/preload", {"can/userbus/", kSystem}},
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
