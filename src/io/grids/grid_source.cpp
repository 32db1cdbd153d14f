#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <memory>
#include <new>

#include "io/files/gdal_at_home.h"
#include "io/files/layer_choice.h"
#include "io/files/quiet_gdal.h"
#include "io/files/text.h"
#include "io/grids/grid_source_internal.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

/// A raster inside another file.
struct Subdataset {
  std::string source;   ///< what GDAL opens
  std::string name;     ///< 'elevation'
  bool is_flat = true;  ///< two dimensions, both of more than one place
};

GDALDatasetUniquePtr open_raster(const std::string& source) {
  return GDALDatasetUniquePtr(GDALDataset::Open(source.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
}

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void copy_to_memory(const std::string& file, std::string_view bytes) {
  const std::unique_ptr<VSILFILE, int (*)(VSILFILE*)> out(VSIFOpenL(file.c_str(), "wb"),
                                                          &VSIFCloseL);
  if (!out || VSIFWriteL(bytes.data(), 1, bytes.size(), out.get()) != bytes.size()) {
    throw std::bad_alloc();
  }
}

/// The folder of a copy without the mark, with the CRS that stands beside the file; none where the
/// file has no mark. GDAL knows a text grid by its first word.
std::shared_ptr<const std::string> without_mark(const fs::path& path) {
  std::string head(kByteOrderMark.size(), '\0');
  std::ifstream(path, std::ios::binary)
      .read(head.data(), static_cast<std::streamsize>(head.size()));
  if (head != kByteOrderMark) return nullptr;
  std::shared_ptr<const std::string> folder(new std::string("/vsimem/swathplan-without-mark"),
                                            [](const std::string* f) {
                                              VSIRmdirRecursive(f->c_str());
                                              delete f;
                                            });
  const std::string text = bytes_of(path);
  copy_to_memory(*folder + "/" + path.filename().string(),
                 std::string_view(text).substr(kByteOrderMark.size()));
  for (const char* extension : {".prj", ".PRJ"}) {
    const fs::path beside = fs::path(path).replace_extension(extension);
    if (!fs::is_regular_file(beside)) continue;
    copy_to_memory(*folder + "/" + path.stem().string() + ".prj", bytes_of(beside));
    break;
  }
  return folder;
}

/// 'NETCDF:"/a/b.nc":depth' -> 'depth', 'GTIFF_DIR:2:/a/b.tif' -> '2'.
std::string name_in(const std::string& source, const std::string& file) {
  const std::size_t at = source.find(file);
  std::string name = source.substr(at + file.size());
  if (name.find_first_not_of("\":/") == std::string::npos) {
    name = source.substr(0, at);
    name.erase(0, name.find(':') + 1);
  }
  const std::size_t first = name.find_first_not_of("\":/");
  const std::size_t last = name.find_last_not_of("\":/");
  return first == std::string::npos ? name : name.substr(first, last - first + 1);
}

/// '[2x5x6] z (32-bit floating-point)' has three dimensions.
bool is_flat(const std::string& description) {
  const std::size_t end = description.find(']');
  if (!description.starts_with('[') || end == std::string::npos) return true;
  const std::vector<std::string_view> sizes =
      split(std::string_view(description).substr(1, end - 1), 'x');
  return sizes.size() == 2 && std::none_of(sizes.begin(), sizes.end(),
                                           [](std::string_view size) { return size == "1"; });
}

std::vector<Subdataset> subdatasets_of(GDALDataset& data, const fs::path& path) {
  std::vector<Subdataset> found;
  char** list = data.GetMetadata("SUBDATASETS");
  for (int i = 1;
       const char* source = CSLFetchNameValue(list, fmt::format("SUBDATASET_{}_NAME", i).c_str());
       ++i) {
    const char* text = CSLFetchNameValue(list, fmt::format("SUBDATASET_{}_DESC", i).c_str());
    const std::string name = source;
    if (name.find(path.string()) == std::string::npos) continue;  // never another file
    found.push_back({name, name_in(name, path.string()), is_flat(text != nullptr ? text : "")});
  }
  return found;
}

/// The name of a variable without the groups that it lies in.
std::string last_part(const std::string& name) {
  return lower(std::string_view(name).substr(name.find_last_of('/') + 1));
}

bool is_seafloor_name(const std::string& name) {
  constexpr std::array kNames = {"elevation", "depth", "z", "band1", "bathymetry", "height"};
  const std::string last = last_part(name);
  return std::find(kNames.begin(), kNames.end(), last) != kNames.end();
}

const Subdataset& choose(const std::vector<Subdataset>& all, const std::string& layer,
                         const fs::path& path) {
  std::vector<std::string> names;
  std::vector<std::size_t> flat, named;
  for (std::size_t i = 0; i < all.size(); ++i) {
    names.push_back(all[i].name);
    if (!all[i].is_flat) continue;
    flat.push_back(i);
    if (is_seafloor_name(all[i].name)) named.push_back(i);
  }
  if (const auto chosen = chosen_layer(layer, names)) return all[*chosen];
  std::vector<std::string> last;
  for (const std::string& name : names) last.push_back(last_part(name));
  if (const auto chosen = chosen_layer(layer, last)) return all[*chosen];
  if (flat.size() == 1) return all[flat.front()];
  if (named.size() == 1) return all[named.front()];
  refuse_layers(path, names);
}

std::string band_name(GDALDataset& data, int band) {
  const char* name = data.GetRasterBand(band)->GetDescription();
  return name == nullptr ? "" : name;
}

/// A picture shows the seafloor in colours; its numbers are no depths.
void refuse_picture(GDALDataset& data, const fs::path& path) {
  bool red = false;
  bool blue = false;
  bool palette = false;
  for (int i = 1; i <= data.GetRasterCount(); ++i) {
    GDALRasterBand& band = *data.GetRasterBand(i);
    const GDALColorInterp colour = band.GetColorInterpretation();
    red = red || colour == GCI_RedBand;
    blue = blue || colour == GCI_BlueBand;
    const bool small = band.GetRasterDataType() == GDT_Byte;
    palette = palette || colour == GCI_PaletteIndex || (small && band.GetColorTable() != nullptr);
  }
  if (!palette && !(red && blue)) return;
  throw InvalidInput(fmt::format(
      "'{}' is a picture ({}): its numbers are colours, no depths; give the grid that the picture "
      "was drawn from",
      path.string(), palette ? "colours of a palette" : "red, green and blue"));
}

void choose_band(GridSource& source, const std::string& layer) {
  const int count = source.data->GetRasterCount();
  if (count < 2) return;
  std::vector<std::string> names;
  for (int i = 1; i <= count; ++i) names.push_back(band_name(*source.data, i));
  std::vector<std::string> numbers;
  for (int i = 1; i <= count; ++i) numbers.push_back(std::to_string(i));
  std::optional<std::size_t> chosen = chosen_layer(layer, names);
  if (!chosen) chosen = chosen_layer(layer, numbers);
  if (chosen) source.band = static_cast<int>(*chosen) + 1;
  if (std::string_view(source.data->GetDriverName()) == "BAG") return;
  const char* extra = source.data->GetMetadataItem("NETCDF_DIM_EXTRA");
  if (extra != nullptr) {
    std::string axes = extra;  // '{time}'
    std::erase_if(axes, [](char c) { return c == '{' || c == '}'; });
    source.warnings.push_back(
        fmt::format("the values run along '{}' too: step {} of {} was read{}", axes, source.band,
                    count, chosen ? "" : "; choose another with <layer> and its number"));
    return;
  }
  const std::string name = band_name(*source.data, source.band);
  source.notes.push_back(fmt::format("band {} of {}{} was read{}", source.band, count,
                                     name.empty() ? "" : " (" + quotable(name) + ")",
                                     chosen ? "" : "; choose another with <layer>"));
}

}  // namespace

GridSource open_grid(const fs::path& path, const std::string& layer) {
  register_gdal();
  check_sources_stay_beside(path);
  GridSource source;
  source.copy = without_mark(path);
  source.data =
      open_raster(source.copy ? *source.copy + "/" + path.filename().string() : path.string());
  if (!source.data) {
    throw InvalidInput(
        fmt::format("'{}' cannot be read as a grid{}; it may be truncated or garbled",
                    path.string(), QuietGdal::why()));
  }
  const std::vector<Subdataset> parts = subdatasets_of(*source.data, path);
  std::vector<std::string> names;
  for (const Subdataset& part : parts) names.push_back(part.name);
  const bool is_empty = source.data->GetRasterCount() == 0;
  const bool is_bag = std::string_view(source.data->GetDriverName()) == "BAG";
  if (is_empty && parts.empty()) {
    throw InvalidInput(fmt::format(
        "'{}' holds no raster band of its own; extract the depths with gdal_translate first",
        path.string()));
  }
  if (is_empty || (!is_bag && chosen_layer(layer, names))) {
    const Subdataset& part = choose(parts, layer, path);
    source.data = open_raster(part.source);
    if (!source.data || source.data->GetRasterCount() == 0) {
      throw InvalidInput(fmt::format("'{}': layer '{}' cannot be read as a grid{}", path.string(),
                                     part.name, QuietGdal::why()));
    }
    if (parts.size() > 1) {
      source.notes.push_back(
          fmt::format("layer '{}' of {} was read", quotable(part.name), parts.size()));
    }
  } else if (parts.size() > 1 && !is_bag) {
    source.warnings.push_back(fmt::format(
        "the file holds {} grids; the first was read, choose another with <layer>", parts.size()));
  }
  refuse_picture(*source.data, path);
  choose_band(source, layer);
  return source;
}

}  // namespace swathplan
