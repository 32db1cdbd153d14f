#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/commands.h"
#include "apps/options.h"
#include "io/seafloor/inspection.h"

namespace swathplan {

void add_inspect_command(CLI::App& app) {
  auto* sub = app.add_subcommand(
      "inspect",
      "What is in a seafloor file: extent, CRS, depths, mesh health, suggested settings");
  auto site = std::make_shared<SiteOptions>();
  auto json = std::make_shared<bool>(false);
  add_site_options(*sub, *site);
  sub->add_flag("--json", *json, "Print as JSON");
  sub->callback([site, json] {
    const ImportedSeafloor imported = import_seafloor(site->file, import_options(*site));
    if (*json) {
      fmt::print("{}\n", inspection_json(imported).dump(2));
    } else {
      fmt::print("{}", inspection_text(imported));
    }
  });
}

}  // namespace swathplan
