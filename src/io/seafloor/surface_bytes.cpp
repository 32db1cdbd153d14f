#include "io/seafloor/surface_bytes.h"

#include <cstring>
#include <type_traits>

#include "mesh/base/error.h"

namespace swathplan {
namespace {

class ByteWriter {
 public:
  template <class T>
  void value(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void text(const std::string& text) {
    value(text.size());
    bytes_ += text;
  }
  void texts(const std::vector<std::string>& list) {
    value(list.size());
    for (const std::string& t : list) text(t);
  }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  [[nodiscard]] T value() {
    T value;
    std::memcpy(&value, next(sizeof value), sizeof value);
    return value;
  }
  /// The number of items that follow, each of at least `least` bytes.
  [[nodiscard]] std::size_t count(std::size_t least) {
    const auto n = value<std::size_t>();
    if (n > bytes_.size() / least) throw InvalidInput("the answer of the mesh reader ends early");
    return n;
  }
  [[nodiscard]] std::string text() {
    const std::size_t n = count(1);
    return {next(n), n};
  }
  [[nodiscard]] std::vector<std::string> texts() {
    std::vector<std::string> list(count(sizeof(std::size_t)));
    for (std::string& t : list) t = text();
    return list;
  }

 private:
  const char* next(std::size_t n) {
    if (n > bytes_.size()) throw InvalidInput("the answer of the mesh reader ends early");
    const char* at = bytes_.data();
    bytes_.remove_prefix(n);
    return at;
  }

  std::string_view bytes_;
};

}  // namespace

std::string to_bytes(const SurfaceData& data) {
  ByteWriter out;
  out.value(data.vertices.size());
  for (const Vec3& v : data.vertices) {
    for (const double x : {v.x(), v.y(), v.z()}) out.value(x);
  }
  out.value(data.faces.size());
  for (const auto& face : data.faces) out.value(face);
  out.text(data.crs_wkt);
  out.text(data.format);
  out.value(data.is_clean);
  out.value(data.z_is_depth);
  out.value(data.spacing);
  out.value(data.float_step);
  out.texts(data.notes);
  out.texts(data.warnings);
  return out.take();
}

SurfaceData surface_from_bytes(std::string_view bytes) {
  ByteReader in(bytes);
  SurfaceData data;
  data.vertices.resize(in.count(3 * sizeof(double)));
  for (Vec3& v : data.vertices) {
    for (const int k : {0, 1, 2}) v[k] = in.value<double>();
  }
  data.faces.resize(in.count(sizeof(data.faces[0])));
  for (auto& face : data.faces) face = in.value<std::array<std::uint32_t, 3>>();
  data.crs_wkt = in.text();
  data.format = in.text();
  data.is_clean = in.value<bool>();
  data.z_is_depth = in.value<bool>();
  data.spacing = in.value<double>();
  data.float_step = in.value<double>();
  data.notes = in.texts();
  data.warnings = in.texts();
  return data;
}

}  // namespace swathplan
