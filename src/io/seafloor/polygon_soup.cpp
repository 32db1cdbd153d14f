#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <string>

#include "io/files/text.h"
#include "io/seafloor/polygon_soup_internal.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
constexpr std::size_t kLongestHeader = 1 << 20;

[[noreturn]] void garbled(const std::filesystem::path& path, const std::string& why) {
  throw InvalidInput(fmt::format("'{}' {}: the file is truncated or garbled; export it again",
                                 path.string(), why));
}

struct PlyCounts {
  std::size_t vertices = 0, faces = 0;
};

bool is_ply_number(std::string_view type) {
  constexpr std::array kTypes = {"char",  "uchar",  "short",   "ushort", "int",   "uint",
                                 "float", "double", "int8",    "uint8",  "int16", "uint16",
                                 "int32", "uint32", "float32", "float64"};
  return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

bool is_ply_float(std::string_view type) {
  return type == "float" || type == "double" || type == "float32" || type == "float64";
}

/// Reads the header of a PLY line by line. CGAL never stops reading one that has no end, believes
/// any count, and crashes over lines that it does not know and over coordinates of other types.
class PlyHeader {
 public:
  explicit PlyHeader(const std::filesystem::path& path)
      : path_(path), size_(std::filesystem::file_size(path)) {}

  PlyCounts read(std::istream& in) {
    std::string line;
    std::size_t read = 0;
    while (std::getline(in, line) && read < kLongestHeader) {
      read += line.size() + 1;
      ++number_;
      const std::vector<std::string_view> words = split(line, ' ');
      if (words.empty()) continue;
      if (words[0] == "end_header" && number_ > 2) {
        check_columns();
        return counts_;
      }
      if (!takes(words)) {
        garbled(path_,
                fmt::format("has line {}, '{}', which no PLY header has", number_, quotable(line)));
      }
    }
    garbled(path_, "has no 'end_header' line");
  }

 private:
  bool takes(const std::vector<std::string_view>& words) {
    if (number_ == 1) return words.size() == 1 && words[0] == "ply";
    if (number_ == 2) return is_format(words);
    if (words[0] == "comment" || words[0] == "obj_info") return true;
    if (words[0] == "element") return words.size() == 3 && (take_element(words), true);
    if (words[0] != "property" || element_.empty()) return false;
    const bool list = words.size() == 5 && words[1] == "list";
    if (!list && words.size() != 3) return false;
    const std::string_view name = words.back();
    if (list && !(is_ply_number(words[2]) && !is_ply_float(words[2]))) return false;
    if (!is_ply_number(words[words.size() - 2])) return false;
    if (element_ == "vertex" && (name == "x" || name == "y" || name == "z")) {
      if (list || !is_ply_float(words[1])) {
        garbled(path_, fmt::format("has '{}' of a type other than float or double", name));
      }
      ++coordinates_;
    }
    if (element_ == "face" && (name == "vertex_indices" || name == "vertex_index")) {
      if (!list || is_ply_float(words[3])) {
        garbled(path_, fmt::format("has '{}' that is no list of whole numbers", name));
      }
      ++indices_;
    }
    return true;
  }

  static bool is_format(const std::vector<std::string_view>& words) {
    return words.size() == 3 && words[0] == "format" &&
           (words[1] == "ascii" || words[1] == "binary_little_endian" ||
            words[1] == "binary_big_endian");
  }

  void take_element(const std::vector<std::string_view>& words) {
    element_ = std::string(words[1]);
    const double count = to_number(words[2]).value_or(-1.0);
    if (!(count >= 0.0) || count > static_cast<double>(size_)) {
      garbled(path_,
              fmt::format("says it holds {} of '{}'", quotable(words[2]), quotable(words[1])));
    }
    if (element_ == "vertex") counts_.vertices = static_cast<std::size_t>(count);
    if (element_ == "face") counts_.faces = static_cast<std::size_t>(count);
  }

  void check_columns() const {
    if (counts_.vertices > 0 && coordinates_ != 3) {
      garbled(path_, "does not have one x, one y and one z for each vertex");
    }
    if (counts_.faces > 0 && indices_ != 1)
      garbled(path_, "does not have one list of corners for each face");
  }

  const std::filesystem::path& path_;
  std::size_t size_;
  std::size_t number_ = 0;
  std::string element_;
  PlyCounts counts_;
  int coordinates_ = 0, indices_ = 0;
};

/// CGAL accepts an ASCII STL that ends too early, even one without a facet.
void check_ascii_stl(const std::filesystem::path& path, std::istream& in) {
  std::string line;
  std::string last;
  while (std::getline(in, line)) {
    if (!trim(line).empty()) last = lower(trim(line));
  }
  if (last.rfind("endsolid", 0) != 0) garbled(path, "does not end with 'endsolid'");
}

/// CGAL makes room for as many corners as a face of an OFF says that it has, whatever it says.
void check_off(const std::filesystem::path& path, std::istream& in) {
  const auto size = static_cast<double>(std::filesystem::file_size(path));
  std::string line;
  double vertices = -1.0;
  double number = 0.0;
  while (std::getline(in, line)) {
    ++number;
    std::vector<std::string_view> words =
        split(std::string_view(line).substr(0, line.find('#')), ' ');
    if (!words.empty() && words[0].ends_with("OFF")) words.erase(words.begin());
    if (words.empty()) continue;
    if (vertices < 0.0) {
      vertices = to_number(words[0]).value_or(0.0);
    } else if (vertices > 0.0) {
      --vertices;
    } else if (const double corners = to_number(words[0]).value_or(0.0); corners > size) {
      garbled(path, fmt::format("says in line {} that a face has {} corners", number,
                                quotable(words[0])));
    }
  }
}

}  // namespace

void read_soup(const std::filesystem::path& path, SoupFormat format, std::vector<Vec3>& vertices,
               std::vector<SoupPolygon>& polygons) {
  std::vector<Kernel::Point_3> points;
  std::ifstream in(path, std::ios::binary);
  PlyCounts counts;
  if (format == SoupFormat::ply) counts = PlyHeader(path).read(in);
  if (format == SoupFormat::ascii_stl) check_ascii_stl(path, in);
  if (format == SoupFormat::off) check_off(path, in);
  in.clear();
  in.seekg(0);
  bool ok = false;
  try {
    if (format == SoupFormat::ply) ok = CGAL::IO::read_PLY(in, points, polygons);
    if (format == SoupFormat::off) ok = CGAL::IO::read_OFF(in, points, polygons);
    if (format == SoupFormat::ascii_stl) ok = CGAL::IO::read_STL(in, points, polygons);
  } catch (const std::exception&) {
    ok = false;
  }
  if (!ok) garbled(path, "cannot be read to its end");
  if (format == SoupFormat::ply &&
      (points.size() != counts.vertices || polygons.size() < counts.faces)) {
    garbled(path, fmt::format("holds {} of {} vertices and {} of {} faces", points.size(),
                              counts.vertices, polygons.size(), counts.faces));
  }
  for (const Kernel::Point_3& p : points) vertices.emplace_back(p.x(), p.y(), p.z());
}

}  // namespace swathplan
