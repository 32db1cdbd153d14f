#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "apps/adapt/adapt.h"
#include "apps/commands.h"
#include "mesh/base/allocator.h"
#include "mesh/base/error.h"

namespace {

constexpr int kDataError = 1;
constexpr int kUsageError = 2;

int complain(const char* what, int code) {
  fmt::print(stderr, "swathplan: {}\n", what);
  return code;
}

/// @throws UsageError for a first word that is no command, which CLI11 would not name.
void check_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::string names;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->check_name(argv[1])) return;
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  throw swathplan::UsageError(
      fmt::format("'{}' is not a command; choose one of {}", argv[1], names));
}

}  // namespace

int main(int argc, char** argv) {
  swathplan::keep_freed_memory();
  CLI::App app{"Offline hydrographic survey designer: plans routes and predicts their coverage."};
  app.set_version_flag("--version", SWATHPLAN_VERSION);
  app.require_subcommand(1);
  swathplan::add_inspect_command(app);
  swathplan::add_synth_command(app);
  swathplan::add_plan_command(app);
  swathplan::add_compare_command(app);
  swathplan::add_lines_command(app);
  swathplan::add_score_command(app);
  swathplan::add_export_command(app);
  swathplan::add_adapt_command(app);
  try {
    check_command(app, argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : kUsageError;
  } catch (const swathplan::UsageError& e) {
    return complain(e.what(), kUsageError);
  } catch (const std::bad_alloc&) {
    return complain("not enough memory; use a coarser --resolution or a smaller --area",
                    kDataError);
  } catch (const std::exception& e) {
    return complain(e.what(), kDataError);
  }
  return 0;
}
