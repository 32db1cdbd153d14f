#include "apps/adapt/adapt.h"

#include "apps/adapt/adapt_planners.h"

namespace swathplan {

void add_adapt_command(CLI::App& app) {
  auto* adapt = app.add_subcommand(
      "adapt", "The adaptive side-scan planners: simulate a mission, study many, or plan live");
  adapt->require_subcommand(1);
  add_adapt_accordion(*adapt);
  add_adapt_spacing(*adapt);
  add_adapt_quality(*adapt);
}

}  // namespace swathplan
