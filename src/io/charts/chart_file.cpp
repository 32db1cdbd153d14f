#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include "io/charts/chart_file_internal.h"
#include "io/charts/hazard_buffers.h"
#include "io/files/gdal_at_home.h"
#include "io/files/quiet_gdal.h"
#include "io/files/text.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

/// The finest bands by number; 1 and 2 are for whole seas.
constexpr std::array kBands{"",         "overview", "general", "coastal",
                            "approach", "harbour",  "berthing"};
constexpr int kCoarsestBand = 3;

bool is_s57_name(const fs::path& path) { return path.extension() == ".000"; }

GDALDatasetUniquePtr open_s57(const fs::path& path, bool with_updates) {
  const char* const options[] = {with_updates ? "UPDATES=APPLY" : "UPDATES=IGNORE",
                                 "SPLIT_MULTIPOINT=ON",
                                 "ADD_SOUNDG_DEPTH=ON",
                                 "LIST_AS_STRING=ON",
                                 "RETURN_PRIMITIVES=ON",
                                 "RETURN_LINKAGES=ON",
                                 nullptr};
  const char* const drivers[] = {"S57", nullptr};
  return GDALDatasetUniquePtr(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY,
                                                drivers, options, nullptr));
}

}  // namespace

std::set<int> updates_beside(const fs::path& path) {
  std::set<int> numbers;
  std::error_code error;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string end = entry.path().extension().string();
    const bool digits = end.size() == 4 && std::all_of(end.begin() + 1, end.end(), [](char c) {
                          return std::isdigit(static_cast<unsigned char>(c)) != 0;
                        });
    if (digits && entry.path().stem() == path.stem()) numbers.insert(std::stoi(end.substr(1)));
  }
  numbers.erase(0);
  return numbers;
}

namespace {

/// The first feature of DSID, which tells of the whole cell.
OGRFeatureUniquePtr header_of(GDALDataset& file) {
  OGRLayer* layer = layer_named(file, "DSID");
  if (layer == nullptr) return {};
  layer->ResetReading();
  return OGRFeatureUniquePtr(layer->GetNextFeature());
}

int whole_in(const OGRFeature& feature, const char* field) {
  const std::string text = text_in(feature, field);
  return static_cast<int>(to_finite_number(text).value_or(0.0));
}

void fill_cell(const OGRFeature& header, ChartCell& cell) {
  cell.name = fs::path(text_in(header, "DSID_DSNM")).stem().string();
  cell.usage_band = whole_in(header, "DSID_INTU");
  cell.edition = whole_in(header, "DSID_EDTN");
  cell.update = whole_in(header, "DSID_UPDN");
  cell.issued = text_in(header, "DSID_ISDT");
  cell.scale = whole_in(header, "DSPM_CSCL");
  cell.sounding_datum = whole_in(header, "DSPM_SDAT");
}

/// @throws InvalidInput where an update is missing among those that lie beside the cell.
void check_sequence(const fs::path& path, int first, const std::set<int>& beside) {
  std::vector<std::string> missing;
  const int last = beside.empty() ? first : *beside.rbegin();
  for (int n = first + 1; n <= last; ++n) {
    if (beside.count(n) == 0) missing.push_back(fmt::format("{}.{:03}", path.stem().string(), n));
  }
  if (missing.empty()) return;
  throw InvalidInput(fmt::format(
      "'{}' has updates to {} beside it, but {} {} missing: a later update does not make sense "
      "without; get {} from the chart's producer, or take the cell as it was issued into a folder "
      "of its own",
      path.string(), last, fmt::join(missing, ", "), missing.size() == 1 ? "is" : "are",
      missing.size() == 1 ? "it" : "them"));
}

[[noreturn]] void refuse_cell(const fs::path& path) {
  throw InvalidInput(fmt::format(
      "'{}' cannot be read as an S-57 cell{}: it is cut off, an update without its cell, or "
      "encrypted (S-63); give the cell as its producer publishes it",
      path.string(), QuietGdal::why()));
}

GDALDatasetUniquePtr open_cell(const fs::path& path, ChartCell& cell) {
  const GDALDatasetUniquePtr issued = open_s57(path, false);
  OGRFeatureUniquePtr header = issued ? header_of(*issued) : OGRFeatureUniquePtr();
  if (!header) refuse_cell(path);
  fill_cell(*header, cell);
  const int first = cell.update;
  const std::set<int> beside = updates_beside(path);
  check_sequence(path, first, beside);
  GDALDatasetUniquePtr updated = open_s57(path, true);
  header = updated ? header_of(*updated) : OGRFeatureUniquePtr();
  if (!header) refuse_cell(path);
  fill_cell(*header, cell);
  const int last = beside.empty() ? first : std::max(first, *beside.rbegin());
  if (cell.update != last) {
    throw InvalidInput(fmt::format(
        "'{}' was issued with update {} and lies beside updates to {}, but only those to {} can be "
        "applied{}; get the cell's newest edition",
        path.string(), first, last, cell.update, QuietGdal::why()));
  }
  return updated;
}

void check_band(const fs::path& path, const ChartCell& cell) {
  if (cell.usage_band <= 0 || cell.usage_band >= kCoarsestBand) return;
  throw InvalidInput(fmt::format(
      "'{}' is a chart of usage band {} ({}, 1:{}): too coarse to lay survey lines by; take a cell "
      "of the bands approach, harbour or berthing (a name with 4, 5 or 6 in third place)",
      path.string(), cell.usage_band, kBands.at(static_cast<std::size_t>(cell.usage_band)),
      cell.scale));
}

std::uint64_t record_key(int kind, int number) {
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(kind)) << 32U) |
         static_cast<std::uint32_t>(number);
}

template <class Value>
void keep_larger(std::optional<Value>& kept, const std::optional<Value>& other) {
  if (other && (!kept || *other > *kept)) kept = other;
}

/// The QUAPOS that stands for more metres.
void keep_worse(std::optional<int>& kept, const std::optional<int>& other) {
  if (other && (!kept || quapos_m(*other) > quapos_m(*kept))) kept = other;
}

std::optional<int> whole(const std::optional<double>& value) {
  return value ? std::optional<int>(static_cast<int>(*value)) : std::nullopt;
}

}  // namespace

OGRLayer* layer_named(GDALDataset& file, std::string_view name) {
  const std::string wanted = lower(name);
  for (OGRLayer* layer : file.GetLayers()) {
    if (lower(layer->GetName()) == wanted) return layer;
  }
  return nullptr;
}

std::optional<double> number_in(const OGRFeature& feature, const char* field) {
  const int at = feature.GetFieldIndex(field);
  if (at < 0 || feature.IsFieldSetAndNotNull(at) == 0) return {};
  return to_finite_number(feature.GetFieldAsString(at));
}

std::string text_in(const OGRFeature& feature, const char* field) {
  const int at = feature.GetFieldIndex(field);
  return at < 0 || feature.IsFieldSetAndNotNull(at) == 0 ? "" : feature.GetFieldAsString(at);
}

std::string title_of(const ChartCell& cell) {
  if (!cell.is_s57) return cell.name;
  std::string text = fmt::format("{}, edition {}", cell.name, cell.edition);
  if (cell.update > 0) text += fmt::format(" with updates to {}", cell.update);
  if (!cell.issued.empty()) text += fmt::format(" ({})", quotable(cell.issued));
  if (cell.usage_band > 0 && cell.usage_band < static_cast<int>(kBands.size())) {
    text += fmt::format(", {}", kBands.at(static_cast<std::size_t>(cell.usage_band)));
  }
  if (cell.scale > 0) text += fmt::format(", 1:{}", cell.scale);
  return text;
}

std::string datum_name(int number) {
  switch (number) {
    case 1:
      return "mean low water springs";
    case 3:
      return "mean sea level";
    case 5:
      return "mean low water";
    case 8:
      return "Indian spring low water";
    case 12:
      return "mean lower low water";
    case 23:
      return "lowest astronomical tide";
    default:
      return "chart datum";
  }
}

GDALDatasetUniquePtr open_chart(const fs::path& path, ChartCell& cell) {
  register_gdal();
  if (!is_s57_name(path)) {
    check_sources_stay_beside(path);
    cell.name = path.filename().string();
    GDALDatasetUniquePtr file(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
    if (!file) {
      throw InvalidInput(fmt::format("'{}' cannot be read{}", path.string(), QuietGdal::why()));
    }
    return file;
  }
  cell.is_s57 = true;
  GDALDatasetUniquePtr file = open_cell(path, cell);
  check_band(path, cell);
  const OGRFeatureUniquePtr header = header_of(*file);
  const int depth_unit = header ? whole_in(*header, "DSPM_DUNI") : 1;
  if (depth_unit > 1) {
    throw InvalidInput(
        fmt::format("the depths of '{}' are not in metres (DUNI {}), as those of an ENC are",
                    path.string(), depth_unit));
  }
  return file;
}

SpatialQuality::SpatialQuality(GDALDataset& chart) {
  for (const char* name : {"IsolatedNode", "ConnectedNode", "Edge"}) {
    OGRLayer* layer = layer_named(chart, name);
    if (layer == nullptr) continue;
    for (const OGRFeatureUniquePtr& record : *layer) {
      const std::optional<double> posacc = number_in(*record, "POSACC");
      const std::optional<int> quapos = whole(number_in(*record, "QUAPOS"));
      if (!posacc && !quapos) continue;
      records_[record_key(whole_in(*record, "RCNM"), whole_in(*record, "RCID"))] = {posacc, quapos};
    }
    layer->ResetReading();
  }
}

template <class Use>
void SpatialQuality::for_each_record(const OGRFeature& feature, Use use) const {
  const int kinds_at = feature.GetFieldIndex("NAME_RCNM");
  const int numbers_at = feature.GetFieldIndex("NAME_RCID");
  if (kinds_at < 0 || numbers_at < 0) {
    use(Stated{number_in(feature, "POSACC"), whole(number_in(feature, "QUAPOS"))});
    return;
  }
  int kinds = 0;
  int numbers = 0;
  const int* kind = feature.GetFieldAsIntegerList(kinds_at, &kinds);
  const int* number = feature.GetFieldAsIntegerList(numbers_at, &numbers);
  for (int i = 0; i < std::min(kinds, numbers); ++i) {
    const auto found = records_.find(record_key(kind[i], number[i]));
    if (found != records_.end()) use(found->second);
  }
}

std::optional<double> SpatialQuality::posacc_m(const OGRFeature& feature) const {
  std::optional<double> worst;
  for_each_record(feature, [&](const Stated& s) { keep_larger(worst, s.posacc_m); });
  return worst;
}

std::optional<int> SpatialQuality::quapos(const OGRFeature& feature) const {
  std::optional<int> worst;
  for_each_record(feature, [&](const Stated& s) { keep_worse(worst, s.quapos); });
  return worst;
}

}  // namespace swathplan
