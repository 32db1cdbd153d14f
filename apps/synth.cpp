#include <fmt/format.h>

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

void add_synth_command(CLI::App& app) {
  auto* sub = app.add_subcommand("synth", "Write a synthetic seafloor");
  auto command = std::make_shared<SynthCommand>();
  sub->add_option("SHAPE", command->shape, "saddle, shaft, harbour, sea, flat, tilted or stepped")
      ->required();
  sub->add_option("-o,--output", command->file,
                  "File: .obj (any shape), .asc or .tif (shapes on a square lattice)")
      ->required();
  sub->add_option("--width", command->width_m, "flat, tilted, stepped: metres east")
      ->capture_default_str();
  sub->add_option("--height", command->height_m, "flat, tilted, stepped: metres north")
      ->capture_default_str();
  sub->add_option("--depth", command->depth_m,
                  "flat, tilted, stepped: depth at the west edge, metres")
      ->capture_default_str();
  sub->add_option("--depth-east", command->depth_east_m,
                  "stepped: depth of the eastern half, metres")
      ->capture_default_str();
  sub->add_option("--slope", command->slope_deg, "tilted: slope down to the east, degrees")
      ->capture_default_str();
  sub->callback([command] {
    const Seafloor seafloor = make(*command);
    write_seafloor(command->file, seafloor);
  });
}

}  // namespace swathplan
