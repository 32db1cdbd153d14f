#include "io/route/read_route.h"

#include "io/files/text.h"
#include "io/route/route_csv.h"
#include "io/route/route_geojson.h"

namespace swathplan {

ImportedRoute read_route(const std::filesystem::path& path, const Frame& frame,
                         const RouteDefaults& defaults) {
  const std::string text = read_text(path);
  const std::string_view content = trim(text);
  return content.starts_with('{') ? parse_route_geojson(content, path.string(), frame, defaults)
                                  : parse_route_csv(text, path.string(), frame, defaults);
}

}  // namespace swathplan
