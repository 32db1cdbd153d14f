// The options of the commands, as the command line shows them; options.cpp reads them.
#include "apps/options.h"
#include "apps/preset_names.h"

namespace swathplan {

void add_site_options(CLI::App& command, SiteOptions& o) {
  command.add_option("FILE", o.file, "Seafloor: mesh, grid or soundings")->required();
  const std::string group = "Seafloor";
  command.add_option("--crs", o.crs, "CRS of FILE, as EPSG:n or WKT, where it does not say")
      ->group(group);
  command
      .add_option("--water-level", o.water_level, "Height of still water in FILE's datum, metres")
      ->group(group);
  command.add_option("--z-positive", o.z_positive, "Which way z counts in FILE: up or down")
      ->check(CLI::IsMember({"up", "down"}))
      ->group(group);
  command
      .add_option("--z-unit", o.z_unit,
                  "Unit of z: metre, foot, us-foot, fathom or metres in one unit")
      ->group(group);
  command
      .add_option("--xy-unit", o.xy_unit_m,
                  "Metres in one horizontal unit, where the CRS does not say")
      ->group(group);
  command
      .add_option("--longest-edge", o.longest_edge_m,
                  "Soundings: leave out triangles with a longer edge, metres")
      ->group(group);
  command.add_option("--nodata-value", o.nodata_value, "A further z that means 'no data'")
      ->group(group);
  command
      .add_option("--area", o.area, "Survey only inside these polygons (GeoJSON, GeoPackage, ...)")
      ->group(group);
  command.add_option("--no-go", o.no_go, "Never enter these polygons")->group(group);
  command
      .add_option(
          "--run-out-margin", o.run_out_margin_m,
          "The boat may turn so far beyond the data's outer edge, metres; only where no land "
          "is")
      ->capture_default_str()
      ->group(group);
}

void add_scoring_options(CLI::App& command, SurveyOptions& o) {
  const std::string group = "Sonar, vehicle and scoring";
  command.add_option("--resolution", o.resolution_m, "Side of a scoring cell, metres")
      ->capture_default_str()
      ->group(group);
  command.add_option("--ping-spacing", o.ping_spacing_m, "Path length between pings, metres")
      ->capture_default_str()
      ->group(group);
  command.add_option("--sonar", o.sonar, "Sonar preset: " + names(sonar_presets()))
      ->capture_default_str()
      ->group(group);
  command.add_option("--beams", o.beams, "Beams in a fan; overrides the preset")->group(group);
  command.add_option("--max-opening", o.max_opening_deg, "Largest full opening angle, degrees")
      ->group(group);
  command.add_option("--beam-spacing", o.beam_spacing, "equiangular or equidistant")
      ->check(CLI::IsMember({"equiangular", "equidistant"}))
      ->capture_default_str()
      ->group(group);
  command.add_option("--vehicle", o.vehicle, "Vehicle preset: " + names(vehicle_presets()))
      ->capture_default_str()
      ->group(group);
  command.add_option("--draft", o.draft_m, "Draft and depth of the sonar, metres")->group(group);
  command.add_option("--margin", o.margin_m, "Water wanted below the keel, metres")->group(group);
  command.add_option("--squat", o.squat_m, "Deeper by this under way, metres")->group(group);
  command
      .add_option("--clearance", o.clearance_m, "Kept from walls, shoals and no-go areas, metres")
      ->group(group);
  command.add_option("--turn-radius", o.turn_radius_m, "Smallest turn radius, metres")
      ->group(group);
  command.add_option("--speed", o.speed_mps, "Speed on lines, m/s")->group(group);
  command.add_option("--turn-speed", o.turn_speed_mps, "Speed in turns between lines, m/s")
      ->group(group);
  command.add_option("--transit-speed", o.transit_speed_mps, "Speed between areas, m/s")
      ->group(group);
  command.add_option("--endurance", o.endurance_h, "Longest time under way, hours")->group(group);
  command
      .add_option("--contingency", o.contingency_pct,
                  "Allowance for what goes wrong, per cent of the duration (default: 10)")
      ->group(group);
  command.add_option("--power", o.power_w, "Mean power under way, watts")->group(group);
  command.add_option("--nodata", o.nodata, "What beams meet beyond the data: wall or open")
      ->check(CLI::IsMember({"wall", "open"}))
      ->capture_default_str()
      ->group(group);
  command
      .add_option(
          "--noise", o.noise,
          "Tracking errors: none, calm (0.3 m, 2 deg) or rough (1 m, 4 deg); plans are judged "
          "with them")
      ->check(CLI::IsMember({"none", "calm", "rough"}))
      ->capture_default_str()
      ->group(group);
  command.add_option("--lateral-sigma", o.lateral_sigma_m, "Cross-track error, metres")
      ->group(group);
  command.add_option("--heading-sigma", o.heading_sigma_deg, "Heading error, degrees")
      ->group(group);
  command.add_option("--roll-sigma", o.roll_sigma_deg, "Roll that is not compensated, degrees")
      ->group(group);
  command.add_option("--heave-sigma", o.heave_sigma_m, "Heave, metres")->group(group);
  command.add_option("--holiday", o.holiday_m2, "List holidays of at least this, square metres")
      ->capture_default_str()
      ->group(group);
  command.add_flag("--hit-only", o.hit_only, "Leave out the footprint score (faster)")
      ->group(group);
  command.add_option("--seed", o.seed, "Seed of the tracking errors")
      ->check(CLI::Validator(
          [](const std::string& text) {
            return text.starts_with('-') ? std::string("must be a whole number of 0 or more") : "";
          },
          "UINT"))
      ->capture_default_str()
      ->group(group);
  command.add_option("--threads", o.threads, "Threads; 0: all cores (results do not depend on it)")
      ->capture_default_str()
      ->group(group);
}

void add_planning_options(CLI::App& command, SurveyOptions& o) {
  const std::string group = "Planning";
  command
      .add_option("--depth-bands", o.depth_bands,
                  "Depth bands: a number of equal ones, or the depths between them (10,20)")
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--smallest-region", o.smallest_region_m2,
                  "Depth regions under this join a neighbour, square metres (default: 0.3 of a "
                  "face's size squared)")
      ->group(group);
  command
      .add_option("--faces", o.faces,
                  "NUC, MDNUC: the mesh is made of right isosceles triangles or of right-angled "
                  "quads, cut to the outline along the boundary")
      ->check(CLI::IsMember({"triangle", "quad"}))
      ->capture_default_str()
      ->group(group);
  command
      .add_option(
          "--face-size", o.face_size,
          "Hypotenuse of a triangle or side of a quad, as a share of W (default: 0.93, quads "
          "0.75; the best of several meshes where the area holds few faces)")
      ->group(group);
  command
      .add_option("--opening", o.opening,
                  "Opening angle by depth region, or by ping from the depth below")
      ->check(CLI::IsMember({"region", "ping"}))
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--smooth", o.smooth,
                  "none (arcs and straights) or ipopt: smooth the joins between lines, so that "
                  "curvature changes gradually, and the skeleton's path of NUC and MDNUC")
      ->check(CLI::IsMember({"none", "ipopt"}))
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--run-in", o.run_in_m,
                  "Sail this far straight before each line, metres; less than 0 shortens the line")
      ->capture_default_str()
      ->group(group);
  command.add_option("--run-out", o.run_out_m, "... and behind each line, metres")
      ->capture_default_str()
      ->group(group);
  command.add_option("--start", o.start, "Begin near X,Y (coordinates of FILE)")->group(group);
  command
      .add_option("--heading", o.heading_deg,
                  "Azimuth of straight lines, degrees (default: the one with the fewest lines)")
      ->group(group);
  command
      .add_option("--lines", o.lines,
                  "fitted-lines: straight lines, field lines along fronts from long walls, or both "
                  "tried")
      ->check(CLI::IsMember({"straight", "field", "auto"}))
      ->capture_default_str()
      ->group(group);
  auto* coverage =
      command.add_option("--coverage", o.goal_coverage_pct,
                         "fitted-lines: the shortest plan with this coverage, per cent");
  auto* length = command.add_option("--length", o.goal_length_m,
                                    "fitted-lines: the most coverage within so many metres");
  auto* time = command.add_option("--time", o.goal_time_h,
                                  "fitted-lines: the most coverage within so many hours");
  coverage->group(group)->excludes(length)->excludes(time);
  length->group(group)->excludes(time);
  time->group(group);
  command
      .add_option("--cover", o.cover,
                  "fitted-lines, edge-following: lines are laid for and judged by cells that a "
                  "sounding hits, or by cells in a beam's footprint (wider swaths, fewer lines)")
      ->check(CLI::IsMember({"hit", "footprint"}))
      ->capture_default_str()
      ->group(group);
  command
      .add_option(
          "--line-margin", o.line_margin_pct,
          "fitted-lines, edge-following: per cent of the swath by which neighbours overlap, in "
          "reserve against drift and a wrong map; plans are judged without it")
      ->capture_default_str()
      ->group(group);
}

void add_output_options(CLI::App& command, OutputOptions& o) {
  const CLI::Validator a_name(
      [](std::string& text) { return text.empty() ? std::string("is empty; name a folder") : ""; },
      "FOLDER");
  command.add_option("-o,--output", o.folder, "Folder for the results")
      ->check(a_name)
      ->capture_default_str();
  command.add_flag("--json", o.json, "Print the results as JSON");
  command.add_flag("--quiet", o.quiet, "Print nothing but errors");
}

}  // namespace swathplan
