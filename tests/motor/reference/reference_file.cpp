#include "tests/motor/reference/reference_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

namespace reference {
namespace {

constexpr double kSameAbscissa = 1e-9;

[[noreturn]] void refuse(const std::string& what) {
  throw std::runtime_error{what};
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text{line};
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  return cells;
}

std::filesystem::path data_file(std::string_view name, std::string_view extension) {
  return std::filesystem::path{AXISD_TEST_DATA} / "motor" / (std::string{name} + std::string{extension});
}

Table read_table(const std::filesystem::path& path) {
  std::ifstream file{path};
  std::string line;
  if (!std::getline(file, line)) refuse(path.string() + ": cannot be read");
  Table table{split(line)};
  std::vector<double> row;
  while (std::getline(file, line)) {
    row.clear();
    for (const std::string& cell : split(line)) row.push_back(std::stod(cell));
    table.append(row);
  }
  if (table.rows() == 0) refuse(path.string() + ": has no rows");
  return table;
}

nlohmann::json read_json(const std::filesystem::path& path) {
  std::ifstream file{path};
  if (!file) refuse(path.string() + ": cannot be read");
  return nlohmann::json::parse(file);
}

/// Value of @p column of @p ours at abscissa @p x.
double interpolated(const Table& ours, const std::vector<double>& column, double x) {
  const std::vector<double>& xs = ours.abscissa();
  const auto at = std::lower_bound(xs.begin(), xs.end(), x - kSameAbscissa);
  if (at == xs.end()) refuse("our table ends before " + std::to_string(x));
  const auto i = static_cast<std::size_t>(at - xs.begin());
  if (i == 0 || std::abs(xs[i] - x) < kSameAbscissa) return column[i];
  return std::lerp(column[i - 1], column[i], (x - xs[i - 1]) / (xs[i] - xs[i - 1]));
}

std::string number_text(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// A kind of band: the key in the JSON file, the columns it is for, what is held against it.
struct BandKind {
  std::string_view key;
  bool (*applies)(std::string_view column);
  double (*measured)(const Deviation&, double largest);
  std::string_view unit;
};

constexpr std::array kBandKinds{
    BandKind{"max_pct", [](std::string_view) { return true; },
             [](const Deviation& d, double) { return d.max_percent; }, " %"},
    BandKind{"max_abs_K", [](std::string_view c) { return c.ends_with("_C"); },
             [](const Deviation& d, double) { return d.max_absolute; }, " K"},
    BandKind{"u_dc_pct", [](std::string_view c) { return c == "u_dc_V"; },
             [](const Deviation& d, double largest) { return 100.0 * d.max_absolute / largest; },
             " % of the largest"},
    BandKind{"max_counts", [](std::string_view c) { return c.find("counts") != std::string_view::npos; },
             [](const Deviation& d, double) { return d.max_absolute; }, " counts"},
};

/// Holds @p deviation against one set of bands; says in @p words which one it was.
bool within(const nlohmann::json& bands, const Deviation& deviation, double largest, std::string& words) {
  for (const BandKind& kind : kBandKinds) {
    if (!bands.contains(kind.key) || !kind.applies(deviation.column)) continue;
    const double limit = bands.at(kind.key).get<double>();
    words = number_text(limit) + std::string{kind.unit};
    bool inside = kind.measured(deviation, largest) <= limit;
    if (kind.key == "max_pct" && bands.contains("nrmse_pct")) {
      const double rms_limit = bands.at("nrmse_pct").get<double>();
      words += ", RMS " + number_text(rms_limit) + " %";
      inside = inside && deviation.rms_percent <= rms_limit;
    }
    return inside;
  }
  return true;
}

Deviation compare_column(const File& file, const Table& ours, const std::string& name) {
  const std::vector<double>& expected = file.table.column(name);
  const std::vector<double>& column = ours.column(name);
  const auto [lowest, highest] = std::minmax_element(expected.begin(), expected.end());
  const double range = *highest > *lowest ? *highest - *lowest : 1.0;
  Deviation deviation;
  deviation.column = name;
  double squares = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double error = interpolated(ours, column, file.table.abscissa()[i]) - expected[i];
    // Written so that a NaN, once met, stays.
    if (!(deviation.max_absolute >= std::abs(error)) && !std::isnan(deviation.max_absolute))
      deviation.max_absolute = std::abs(error);
    squares += error * error;
  }
  deviation.max_percent = 100.0 * deviation.max_absolute / range;
  deviation.rms_percent = 100.0 * std::sqrt(squares / static_cast<double>(expected.size())) / range;
  const nlohmann::json none = nlohmann::json::object();
  deviation.within_must = within(file.about.value("bands_must", none), deviation, *highest, deviation.must);
  deviation.within_target = within(file.about.value("bands_target", none), deviation, *highest, deviation.target);
  return deviation;
}

void write_table(const std::filesystem::path& path, const Table& table) {
  std::ofstream out{path};
  out.precision(10);
  for (std::size_t c = 0; c < table.names().size(); ++c) out << (c ? "," : "") << table.names()[c];
  out << '\n';
  for (std::size_t r = 0; r < table.rows(); ++r) {
    for (std::size_t c = 0; c < table.names().size(); ++c)
      out << (c ? "," : "") << table.column(table.names()[c])[r];
    out << '\n';
  }
}

std::string quoted(const std::string& text) {
  return '"' + text + '"';
}

void write_results(const std::filesystem::path& folder, const File& file, const Table& ours,
                   const std::vector<Deviation>& deviations) {
  std::filesystem::create_directories(folder);
  write_table(folder / (file.name + ".csv"), ours);
  const std::filesystem::path path = folder / "results.csv";
  const bool fresh = !std::filesystem::exists(path);
  std::ofstream out{path, std::ios::app};
  if (fresh) out << "file,column,max_pct,rms_pct,must,target,max_abs,reached\n";
  for (const Deviation& d : deviations) {
    std::ostringstream line;  // in one piece, so that programs side by side do not mix theirs
    line << file.name << ',' << d.column << ',' << d.max_percent << ',' << d.rms_percent << ',' << quoted(d.must)
         << ',' << quoted(d.target) << ',' << d.max_absolute << ','
         << (d.must.empty()    ? "-"
             : !d.within_must  ? "no"
             : d.within_target ? "target"
                               : "must")
         << '\n';
    out << line.str() << std::flush;
  }
}

}  // namespace

Table::Table(std::vector<std::string> names) : names_{std::move(names)}, values_{names_.size()} {
  if (names_.empty()) throw std::invalid_argument{"a table without columns"};
}

void Table::append(std::span<const double> row) {
  if (row.size() != names_.size()) throw std::invalid_argument{"a row that does not fit its table"};
  for (std::size_t i = 0; i < row.size(); ++i) values_[i].push_back(row[i]);
}

bool Table::has(std::string_view name) const noexcept {
  return std::find(names_.begin(), names_.end(), name) != names_.end();
}

const std::vector<double>& Table::column(std::string_view name) const {
  const auto at = std::find(names_.begin(), names_.end(), name);
  if (at == names_.end()) throw std::out_of_range{"no column " + std::string{name}};
  return values_[static_cast<std::size_t>(at - names_.begin())];
}

Table Table::sorted() const {
  std::vector<std::size_t> order(rows());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return abscissa()[a] < abscissa()[b]; });
  return selected(order);
}

Table Table::selected(std::span<const std::size_t> rows) const {
  Table result{names_};
  for (std::size_t c = 0; c < names_.size(); ++c)
    for (const std::size_t row : rows) result.values_[c].push_back(values_[c].at(row));
  return result;
}

void File::keep_every(std::size_t n) {
  std::vector<std::size_t> kept;
  for (std::size_t row = 0; row < table.rows(); row += n) kept.push_back(row);
  table = table.selected(kept);
}

File::File(std::string_view file_name)
    : name{file_name},
      about(read_json(data_file(file_name, ".json"))),
      table{read_table(data_file(file_name, ".csv"))} {}

double File::number(std::string_view pointer) const {
  return about.at(nlohmann::json::json_pointer{std::string{pointer}}).get<double>();
}

std::vector<Deviation> compare(const File& file, const Table& ours) {
  const Table ascending = ours.sorted();
  std::vector<Deviation> deviations;
  for (const std::string& name : ascending.names()) {
    if (name == file.table.names().front()) continue;
    if (!file.table.has(name)) refuse(file.name + " has no column " + name);
    deviations.push_back(compare_column(file, ascending, name));
  }
  return deviations;
}

void expect_agreement(const File& file, const Table& ours, Band band) {
  const std::vector<Deviation> deviations = compare(file, ours);
  EXPECT_FALSE(deviations.empty()) << file.name << ": nothing compared";
  for (const Deviation& d : deviations) {
    EXPECT_TRUE(band == Band::Target ? d.within_target : d.within_must)
        << file.name << ", " << d.column << ": largest deviation " << d.max_percent << " % of the range ("
        << d.max_absolute << "), RMS " << d.rms_percent << " %; must " << d.must << ", target " << d.target;
  }
  if (const char* const folder = std::getenv("AXISD_PHYSICS_OUT")) write_results(folder, file, ours, deviations);
}

}  // namespace reference
