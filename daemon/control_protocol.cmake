# What the control socket's two sides share; the daemon and the tools link it, whichever comes first.
include_guard(GLOBAL)
axisd_library(control_protocol ${CMAKE_CURRENT_LIST_DIR}/control_protocol.cpp)
target_link_libraries(control_protocol PUBLIC nlohmann_json::nlohmann_json tl::expected)
