#pragma once

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>

namespace swathplan {

/// What a cell says of itself.
struct ChartCell {
  std::string name;  ///< 'US4MD81M'
  int usage_band = 0, edition = 0, update = 0, scale = 0, sounding_datum = 0;
  std::string issued;  ///< '20250923'
  bool is_s57 = false;
};

/// Opens a chart with its updates applied and its spatial records as layers of their own.
/// @throws InvalidInput if it cannot be read (S-63: encrypted), if an update is missing beside it,
///   if its depths are not in metres, or if its usage band is too coarse for lines of a survey.
[[nodiscard]] GDALDatasetUniquePtr open_chart(const std::filesystem::path& path, ChartCell& cell);

/// The numbers of the updates that lie beside a cell ('.001', '.002', ...).
[[nodiscard]] std::set<int> updates_beside(const std::filesystem::path& path);

/// 'US4MD81M, edition 31 with updates to 3 (20250923), approach, 1:80000'.
[[nodiscard]] std::string title_of(const ChartCell& cell);
/// The name of a sounding datum by its number in S-57; 'chart datum' where it has none here.
[[nodiscard]] std::string datum_name(int number);

/// A layer by its name in any case; nullptr where the file has none.
[[nodiscard]] OGRLayer* layer_named(GDALDataset& file, std::string_view name);
/// A field as a number; empty where it is not set or does not exist.
[[nodiscard]] std::optional<double> number_in(const OGRFeature& feature, const char* field);
/// A field as text; empty where it is not set or does not exist.
[[nodiscard]] std::string text_in(const OGRFeature& feature, const char* field);

/// How well the spatial records of a cell are known: POSACC and QUAPOS by record.
class SpatialQuality {
 public:
  explicit SpatialQuality(GDALDataset& chart);
  /// Of all records that the feature is made of. Files without records: its own fields.
  [[nodiscard]] std::optional<double> posacc_m(const OGRFeature& feature) const;
  [[nodiscard]] std::optional<int> quapos(const OGRFeature& feature) const;

 private:
  struct Stated {
    std::optional<double> posacc_m;
    std::optional<int> quapos;
  };
  template <class Use>
  void for_each_record(const OGRFeature& feature, Use use) const;
  std::unordered_map<std::uint64_t, Stated> records_;  ///< by kind and number
};

}  // namespace swathplan
