#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "record/reader.hpp"
#include "record/recorder.hpp"

namespace record {

inline constexpr canopen::Frame kRequest{.id = 0x605, .length = 8, .data = {0x40, 0x60, 0x44, 0, 0, 0, 0, 0}};
inline constexpr canopen::Frame kSync{.id = 0x80};

/// The content of the file at @p path; empty if there is none.
inline std::string content_of_file(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

/// All records of @p content, and how it ends.
struct Recorded {
  std::vector<Record> records{};
  Reader::Ending ending = Reader::Ending::NotYet;
  std::size_t position = 0;
  std::size_t skipped = 0;
};
inline Recorded read_all(const std::string& content) {
  auto reader = Reader::open(std::as_bytes(std::span{content}));
  if (!reader) return {};
  Recorded all;
  while (auto record = reader->next()) all.records.push_back(*record);
  all.ending = reader->ending();
  all.position = reader->position();
  all.skipped = reader->skipped();
  return all;
}

/// How many of @p records are of type Content.
template <class Content>
std::size_t count(const std::vector<Record>& records) {
  std::size_t found = 0;
  for (const Record& record : records)
    if (std::holds_alternative<Content>(record.content)) ++found;
  return found;
}

inline Segments::Plan plan_in(const std::filesystem::path& folder) {
  return {.folder = folder,
          .name = "run",
          .head = R"({"interface":"vcan0","node_id":5,"wall_clock_ns":1700000000000000000,)"
                  R"("signals":[{"name":"1/r0063","unit":"1/min"}]})",
          .interface = "vcan0",
          .wall_clock = std::chrono::seconds{1700000000},
          .most_bytes = std::uint64_t{1} << 20,
          .by_faults = false};
}

}  // namespace record
