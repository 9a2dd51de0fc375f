#include "gateway/api/own_metrics.hpp"

#include <fstream>
#include <string_view>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

namespace gateway {
namespace {

constexpr double kMicrosecond = 1e-6;

double seconds_of(const timeval& time) noexcept {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * kMicrosecond;
}

double processor_time() noexcept {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}

/// Bytes that are in memory.
std::size_t resident_memory() {
  std::size_t size = 0;
  std::size_t resident = 0;
  std::ifstream{"/proc/self/statm"} >> size >> resident;
  return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

std::string head_of(std::string_view name, std::string_view type, std::string_view help) {
  return fmt::format("# HELP {0} {2}\n# TYPE {0} {1}\n", name, type, help);
}

template <class Value>
std::string family(std::string_view name, std::string_view type, std::string_view help, Value value) {
  return head_of(name, type, help) + fmt::format("{} {}\n", name, value);
}

}  // namespace

std::string own_metrics(const Counters& counters, std::size_t daemons, std::size_t units) {
  std::string text = head_of("axisd_http_requests_total", "counter", "Requests answered, by status of HTTP.");
  for (const auto& [status, count] : counters.answers)
    text += fmt::format("axisd_http_requests_total{{status=\"{}\"}} {}\n", status, count);
  text += family("axisd_http_connections", "gauge", "Connections that are open.", counters.connections);
  text += family("axisd_http_viewers", "gauge", "Streams that are open.", counters.viewers);
  text += family("axisd_http_cut_off_viewers_total", "counter", "Streams ended because they were not read.",
                 counters.cut_off_viewers);
  text += family("axisd_http_late_requests_total", "counter",
                 "Connections closed because no request came in time.", counters.late_requests);
  text += family("axisd_http_daemons", "gauge", "Daemons that can be reached.", daemons);
  text += family("axisd_http_units", "gauge", "Units that can be reached.", units);
  text += family("process_cpu_seconds_total", "counter", "Processor time of the gateway.", processor_time());
  text += family("process_resident_memory_bytes", "gauge", "Memory of the gateway.", resident_memory());
  return text;
}

}  // namespace gateway
