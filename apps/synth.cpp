#include <fmt/format.h>

#include <memory>

#include "apps/commands.h"
#include "io/seafloor/write_seafloor.h"
#include "mesh/base/error.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

struct SynthCommand {
  std::string shape;
  std::filesystem::path file;
  double width_m = 100.0, height_m = 100.0, depth_m = 10.0, depth_east_m = 20.0, slope_deg = 10.0;
};

Seafloor make(const SynthCommand& c) {
  if (c.shape == "saddle") return saddle();
  if (c.shape == "shaft") return shaft();
  if (c.shape == "harbour") return harbour();
  if (c.shape == "sea") return sea();
  if (c.shape == "flat") return flat(c.width_m, c.height_m, c.depth_m);
  if (c.shape == "tilted")
    return tilted(c.width_m, c.height_m, c.depth_m, Angle::degrees(c.slope_deg));
  if (c.shape == "stepped") return stepped(c.width_m, c.height_m, c.depth_m, c.depth_east_m);
  throw UsageError(fmt::format(
      "synth '{}': no such seafloor; choose saddle, shaft, harbour, sea, flat, tilted or stepped",
      c.shape));
}

}  // namespace

Command synth_command() {
  auto c = std::make_shared<SynthCommand>();
  const std::string group;
  const std::vector<std::string> plain{"flat", "tilted", "stepped"};
  return {
      "synth",
      "Write a synthetic seafloor",
      {chooser(argument("SHAPE", c->shape, "saddle, shaft, harbour, sea, flat, tilted or stepped")),
       required(path("-o,--output", group, c->file,
                     "File: .obj (any shape), .asc or .tif (shapes on a square lattice)", "")),
       used_by(plain, real("--width", group, c->width_m, kMetres, above(0.0),
                           "flat, tilted, stepped: metres east", "width_m")),
       used_by(plain, real("--height", group, c->height_m, kMetres, above(0.0),
                           "flat, tilted, stepped: metres north", "height_m")),
       used_by(plain, real("--depth", group, c->depth_m, kMetres, above(0.0),
                           "flat, tilted, stepped: depth at the west edge, metres", "depth_m")),
       used_by({"stepped"}, real("--depth-east", group, c->depth_east_m, kMetres, above(0.0),
                                 "stepped: depth of the eastern half, metres", "depth_east_m")),
       used_by({"tilted"}, real("--slope", group, c->slope_deg, kDegrees, within(0.0, 89.0),
                                "tilted: slope down to the east, degrees", "slope_deg"))},
      [c] { write_seafloor(c->file, make(*c)); },
      {}};
}

}  // namespace swathplan
