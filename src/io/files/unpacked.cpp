#include "io/files/unpacked.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <vector>

#include "io/files/gdal_at_home.h"
#include "io/files/layer_choice.h"
#include "io/files/quiet_gdal.h"
#include "io/files/text.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t{8} << 30;  ///< unpacked, all files together
constexpr std::size_t kMostFiles = 1000;

bool starts_with_bytes(const fs::path& path, std::string_view bytes) {
  std::string head(bytes.size(), '\0');
  std::ifstream(path, std::ios::binary)
      .read(head.data(), static_cast<std::streamsize>(head.size()));
  return head == bytes;
}

enum class Packing { none, zip, tar, gzip };

Packing packing_of(const fs::path& path) {
  const std::string name = lower(path.filename().string());
  if (name.ends_with(".zip") && starts_with_bytes(path, "PK\x03\x04")) return Packing::zip;
  if (name.ends_with(".tar")) return Packing::tar;
  if (!starts_with_bytes(path, "\x1f\x8b")) return Packing::none;
  if (name.ends_with(".tgz") || name.ends_with(".tar.gz")) return Packing::tar;
  return name.ends_with(".gz") ? Packing::gzip : Packing::none;
}

/// A name that stays in the folder.
bool is_safe(const std::string& name) {
  const fs::path path(name);
  return !name.empty() && path.is_relative() && name.find('\\') == std::string::npos &&
         std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
}

/// Copies one file out of GDAL's virtual file system. Returns its bytes.
std::size_t copy_out(const std::string& source, const fs::path& target, std::size_t most,
                     const fs::path& packed) {
  const std::unique_ptr<VSILFILE, int (*)(VSILFILE*)> in(VSIFOpenL(source.c_str(), "rb"),
                                                         &VSIFCloseL);
  fs::create_directories(target.parent_path());
  std::ofstream out(target, std::ios::binary);
  std::vector<char> block(1 << 20);
  std::size_t total = 0;
  CPLErrorReset();
  for (std::size_t got = 1; in && out && got > 0;) {
    got = VSIFReadL(block.data(), 1, block.size(), in.get());
    total += got;
    if (total > most) {
      throw InvalidInput(fmt::format("'{}' is over {} GiB when unpacked; unpack it and crop it",
                                     packed.string(), kMostBytes >> 30));
    }
    out.write(block.data(), static_cast<std::streamsize>(got));
  }
  if (!in || CPLGetLastErrorType() == CE_Failure) {
    throw InvalidInput(fmt::format("'{}' cannot be unpacked to its end{}; copy it again",
                                   packed.string(), QuietGdal::why()));
  }
  if (!out.flush()) {
    throw InvalidInput(fmt::format("'{}' cannot be unpacked: the temporary folder '{}' is full",
                                   packed.string(), fs::temp_directory_path().string()));
  }
  return total;
}

/// Unpacks all files of an archive; returns their names.
std::vector<std::string> unpack_all(const std::string& source, const fs::path& folder,
                                    const fs::path& packed) {
  const std::unique_ptr<char*, void (*)(char**)> list(VSIReadDirRecursive(source.c_str()),
                                                      &CSLDestroy);
  std::vector<std::string> names;
  std::size_t total = 0;
  for (char** entry = list.get(); entry != nullptr && *entry != nullptr; ++entry) {
    const std::string name = *entry;
    const std::string inner = fmt::format("{}/{}", source, name);
    VSIStatBufL status;
    if (VSIStatL(inner.c_str(), &status) != 0 || VSI_ISDIR(status.st_mode)) continue;
    if (!is_safe(name) || names.size() >= kMostFiles) {
      throw InvalidInput(
          fmt::format("'{}' holds {}; unpack it and name the file to read", packed.string(),
                      names.size() >= kMostFiles ? "too many files" : "a file outside its folder"));
    }
    total += copy_out(inner, folder / name, kMostBytes - total, packed);
    names.push_back(name);
  }
  return names;
}

/// True for a file that only goes with others, or tells about them.
bool is_companion(const std::string& name) {
  constexpr std::array kCompanions = {
      ".prj", ".xml",  ".tfw", ".jgw", ".pgw", ".wld",  ".dbf", ".shx", ".cpg", ".sbn",
      ".sbx", ".qpj",  ".qix", ".ovr", ".hdr", ".clr",  ".stx", ".qml", ".met", ".pdf",
      ".md",  ".html", ".htm", ".jpg", ".png", ".docx", ".lyr", ".log", ".rrd", ".txt"};
  const fs::path path(name);
  const std::string extension = lower(path.extension().string());
  return path.filename().string().starts_with('.') || name.starts_with("__MACOSX/") ||
         std::find(kCompanions.begin(), kCompanions.end(), extension) != kCompanions.end();
}

/// '.000', '.001', ...: a cell of an electronic chart, its updates, or the catalogue of a set.
bool has_cell_number(const std::string& name) {
  const std::string extension = fs::path(name).extension().string();
  return extension.size() == 4 && std::all_of(extension.begin() + 1, extension.end(),
                                              [](char c) { return c >= '0' && c <= '9'; });
}

bool is_cell(const std::string& name) { return fs::path(name).extension() == ".000"; }

/// Updates go with their cell: they are laid beside it, and do not count as files to choose from.
void lay_updates_beside(std::vector<std::string>& names, const fs::path& folder) {
  if (std::none_of(names.begin(), names.end(), is_cell)) return;
  std::vector<std::string> others;
  for (const std::string& name : names) {
    if (is_cell(name) || !has_cell_number(name)) {
      others.push_back(name);
      continue;
    }
    for (const std::string& cell : names) {
      const fs::path beside = folder / fs::path(cell).parent_path() / fs::path(name).filename();
      if (!is_cell(cell) || fs::path(cell).stem() != fs::path(name).stem()) continue;
      std::error_code is_there;
      fs::copy_file(folder / name, beside, fs::copy_options::skip_existing, is_there);
    }
  }
  names = std::move(others);
}

std::string choose_file(const std::vector<std::string>& names, const std::string& layer,
                        const fs::path& packed) {
  std::vector<std::string> files;
  std::copy_if(names.begin(), names.end(), std::back_inserter(files),
               [](const std::string& name) { return !is_companion(name); });
  if (files.empty()) {
    std::copy_if(names.begin(), names.end(), std::back_inserter(files), [](const std::string& n) {
      return lower(n).ends_with(".txt") && !n.starts_with("__MACOSX/");
    });
  }
  if (files.empty()) files = names;
  if (files.empty()) {
    throw InvalidInput(fmt::format("'{}' holds no file, or cannot be unpacked{}", packed.string(),
                                   QuietGdal::why()));
  }
  if (files.size() == 1) return files.front();
  std::vector<std::string> plain, stems;
  for (const std::string& name : files) {
    plain.push_back(fs::path(name).filename().string());
    stems.push_back(fs::path(name).stem().string());
  }
  for (const auto* have : {&files, &plain, &stems}) {
    if (const auto chosen = chosen_layer(layer, *have)) return files[*chosen];
  }
  constexpr std::size_t kMostNames = 20;
  std::vector<std::string> shown(
      files.begin(),
      files.begin() + static_cast<std::ptrdiff_t>(std::min(files.size(), kMostNames)));
  for (std::string& name : shown) name = quotable(name);
  throw InvalidInput(fmt::format(
      "'{}' holds {} files ({}{}); choose one with <layer>, or unpack it and name the file",
      packed.string(), files.size(), fmt::join(shown, ", "),
      files.size() > kMostNames ? ", ..." : ""));
}

fs::path new_folder() {
  std::string name = (fs::temp_directory_path() / "swathplan-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw InvalidInput(
        fmt::format("no temporary folder can be made in '{}'", fs::temp_directory_path().string()));
  }
  return name;
}

void remove_folder(const fs::path& folder) {
  std::error_code ignored;
  fs::remove_all(folder, ignored);
}

fs::path unpack(const fs::path& packed, const fs::path& folder, const std::string& layer) {
  const QuietGdal quiet;
  register_gdal();
  const std::string whole = fs::absolute(packed).string();
  const Packing packing = packing_of(packed);
  if (packing == Packing::gzip) {
    // GDAL would else note the size in a file beside the packed one.
    const CPLConfigOptionSetter no_notes("CPL_VSIL_GZIP_WRITE_PROPERTIES", "NO", false);
    fs::path target = folder / packed.filename().stem();
    copy_out("/vsigzip/" + whole, target, kMostBytes, packed);
    return target;
  }
  const std::string system = packing == Packing::zip ? "/vsizip/{" : "/vsitar/{";
  std::vector<std::string> names = unpack_all(system + whole + "}", folder, packed);
  lay_updates_beside(names, folder);
  return folder / choose_file(names, layer, packed);
}

}  // namespace

bool is_packed(const fs::path& path) { return packing_of(path) != Packing::none; }

Unpacked::Unpacked(const fs::path& packed, const std::string& layer)
    : packed_(packed), folder_(new_folder()) {
  try {
    file_ = unpack(packed, folder_, layer);
  } catch (...) {
    remove_folder(folder_);
    throw;
  }
}

Unpacked::~Unpacked() { remove_folder(folder_); }

std::string Unpacked::in_words(std::string text) const {
  const std::string folder = folder_.string() + "/";
  const std::string packed = packed_.string() + "/";
  for (std::size_t at = text.find(folder); at != std::string::npos;
       at = text.find(folder, at + packed.size())) {
    text.replace(at, folder.size(), packed);
  }
  return text;
}

}  // namespace swathplan
