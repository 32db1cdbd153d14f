#include "io/files/known_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

#include "io/files/text.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

constexpr const char* kGridIt =
    "grid it in your hydrographic software and export a GeoTIFF, a BAG or soundings (x y z)";
constexpr const char* kExport = "export a GeoTIFF, a BAG or soundings (x y z) from it";
constexpr const char* kUnpack = "unpack it first and name the file in it";

/// What stands in the first bytes of a kind of file.
struct Magic {
  std::string_view bytes;
  const char* kind;
  const char* advice;
};

constexpr std::array<Magic, 13> kMagic{{
    {"ASTM-E57", "a point cloud (E57)", "export soundings (x y z) or uncompressed LAS from it"},
    {"%PDF", "a PDF document", "give the grid or the soundings that it shows"},
    {"\xD0\xCF\x11\xE0", "an old Office document", "save the sheet as CSV"},
    {"7z\xBC\xAF\x27\x1C", "packed (7z)", kUnpack},
    {"Rar!", "packed (RAR)", kUnpack},
    {"\xFD\x37zXZ", "packed (xz)", kUnpack},
    {"BZh", "packed (bzip2)", kUnpack},
    {"\x28\xB5\x2F\xFD", "packed (zstd)", kUnpack},
    {"MATLAB ", "a MATLAB file", "export soundings (x y z) or a GeoTIFF from it"},
    {"\x93NUMPY", "a NumPy array without places", "export soundings (x y z) or a GeoTIFF from it"},
    {"version https://git-lfs", "a pointer of Git LFS, not the data", "fetch it with git lfs pull"},
    {"\x01\x16", "a raw sonar file (EdgeTech JSF)", kGridIt},
    {"FTP NEW", "a raw survey file of HYPACK", kGridIt},
}};

std::uint32_t number_at(std::string_view head, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(head[at + i])) << (8 * i);
  }
  return value;
}

/// Length, STX, type, ..., ETX, check sum.
bool is_kongsberg_all(std::string_view head, const std::string& extension) {
  const std::size_t length = number_at(head, 0);
  if (head[4] != '\x02' || length < 12 || length > 10'000'000) return false;
  if (4 + length <= head.size()) return head[4 + length - 3] == '\x03';
  return extension == ".all" || extension == ".wcd";
}

/// Length, '#' and three capitals.
bool is_kmall(std::string_view head) {
  return number_at(head, 0) < 100'000'000 && head[4] == '#' &&
         std::all_of(head.begin() + 5, head.begin() + 8,
                     [](char c) { return c >= 'A' && c <= 'Z'; });
}

struct Kind {
  const char* kind = nullptr;
  const char* advice = nullptr;
};

Kind kind_by_bytes(std::string_view head, const std::string& extension) {
  if (extension == ".csar") return {"a CARIS CSAR surface or cloud", kExport};
  if (extension == ".xlsx" || extension == ".ods") return {"a spreadsheet", "save it as CSV"};
  const std::string start = lower(trim(head.substr(0, 64)));
  if (start.starts_with("<!doctype html") || start.starts_with("<html")) {
    return {"a web page", "a download may have failed: fetch the file again"};
  }
  for (const Magic& magic : kMagic) {
    if (head.starts_with(magic.bytes)) return {magic.kind, magic.advice};
  }
  if (head.size() < 16) return {};
  if (is_kmall(head)) return {"a raw multibeam file (Kongsberg KMALL)", kGridIt};
  if (is_kongsberg_all(head, extension)) return {"a raw multibeam file (Kongsberg ALL)", kGridIt};
  if (head.starts_with("CDF") && head.find("xysize") != std::string_view::npos &&
      head.find("x_range") != std::string_view::npos) {
    return {"a grid of GMT's old kind (version 3)",
            "convert it ('gmt grdconvert OLD.grd=cf NEW.grd=nf'), or export a GeoTIFF"};
  }
  if (number_at(head, 4) == 0xFFFF) return {"a raw multibeam file (Teledyne Reson S7K)", kGridIt};
  if (head.substr(0, 32).find("GSF-v") != std::string_view::npos) {
    return {"a multibeam file (GSF)", kGridIt};
  }
  if (extension == ".xtf" && head[0] == '{') return {"a raw sonar file (XTF)", kGridIt};
  return {};
}

}  // namespace

void refuse_foreign(const fs::path& path) {
  std::string head(std::size_t{1} << 16, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  const Kind kind = kind_by_bytes(head, lower(path.extension().string()));
  if (kind.kind == nullptr) return;
  throw InvalidInput(fmt::format("'{}' is {}, which cannot be read here: {}", path.string(),
                                 kind.kind, kind.advice));
}

}  // namespace swathplan
