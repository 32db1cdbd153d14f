#include "io/seafloor/true_scale.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/files/crs.h"

namespace swathplan {

MapScaleAtData map_scale(const std::string& crs_wkt, const Box2& data) {
  const double unit = metres_per_unit(crs_wkt);
  const Vec2 middle = 0.5 * (data.min + data.max);
  const GroundScale at_middle = ground_scale(crs_wkt, middle);
  std::vector<double> scales{at_middle.along_x, at_middle.along_y};
  for (const Vec2& corner :
       {data.min, data.max, Vec2(data.min.x(), data.max.y()), Vec2(data.max.x(), data.min.y())}) {
    const GroundScale scale = ground_scale(crs_wkt, corner);
    scales.insert(scales.end(), {scale.along_x, scale.along_y});
  }
  const auto all_near = [&](double wanted) {
    return std::all_of(scales.begin(), scales.end(), [&](double scale) {
      return std::abs(scale - wanted) <= kMapScaleSlack * wanted;
    });
  };
  if (all_near(unit)) return {MapScale::true_to_ground, unit};
  const double ground = 0.5 * (at_middle.along_x + at_middle.along_y);
  return {all_near(ground) ? MapScale::even : MapScale::uneven, ground};
}

}  // namespace swathplan
