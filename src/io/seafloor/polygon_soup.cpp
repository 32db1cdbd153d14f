#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <fmt/format.h>

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

/// CGAL never stops reading a PLY whose header has no end. It also believes any count.
PlyCounts check_ply(const std::filesystem::path& path, std::istream& in) {
  PlyCounts counts;
  const std::size_t size = std::filesystem::file_size(path);
  std::string line;
  std::size_t read = 0;
  while (std::getline(in, line) && read < kLongestHeader) {
    read += line.size() + 1;
    const std::vector<std::string_view> words = split(line, ' ');
    if (!words.empty() && words[0] == "end_header") return counts;
    if (words.size() < 3 || words[0] != "element") continue;
    const double count = to_number(words[2]).value_or(-1.0);
    if (!(count >= 0.0) || count > static_cast<double>(size)) {
      garbled(path,
              fmt::format("says it holds {} of '{}'", quotable(words[2]), quotable(words[1])));
    }
    if (words[1] == "vertex") counts.vertices = static_cast<std::size_t>(count);
    if (words[1] == "face") counts.faces = static_cast<std::size_t>(count);
  }
  garbled(path, "has no 'end_header' line");
}

/// CGAL accepts an ASCII STL that ends too early, even one without a facet.
void check_ascii_stl(const std::filesystem::path& path, std::istream& in) {
  std::string line;
  std::string last;
  while (std::getline(in, line)) {
    if (!trim(line).empty()) last = lower(trim(line));
  }
  if (last.rfind("endsolid", 0) != 0) garbled(path, "does not end with 'endsolid'");
}

}  // namespace

void read_soup(const std::filesystem::path& path, SoupFormat format, std::vector<Vec3>& vertices,
               std::vector<SoupPolygon>& polygons) {
  std::vector<Kernel::Point_3> points;
  std::ifstream in(path, std::ios::binary);
  PlyCounts counts;
  if (format == SoupFormat::ply) counts = check_ply(path, in);
  if (format == SoupFormat::ascii_stl) check_ascii_stl(path, in);
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
