#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "apps/commands.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

struct DemoCommand {
  std::filesystem::path folder = "swathplan-demo";
  /// NUC is left out: MDNUC shows the same.
  std::string planners = "back-and-forth,multi-depth,mdnuc,fitted-lines";
  bool quiet = false;
  Command compare;
};

/// A seafloor that comes with the program. It is found from where the program lies, so that an
/// unpacked package works in any folder.
std::filesystem::path sample(const std::string& name) {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  std::filesystem::path file =
      (program.parent_path() / SWATHPLAN_SAMPLES / name).lexically_normal();
  if (!std::filesystem::exists(file)) {
    throw InvalidInput(
        fmt::format("'{}' is not there, a seafloor that comes with the program; install the "
                    "program anew, or write it with 'swathplan synth harbour -o {}' and run "
                    "'swathplan compare {}'",
                    file.string(), name, name));
  }
  return file;
}

void run(const DemoCommand& command) {
  const std::string file = sample("harbour.asc").string();
  const std::string folder = command.folder.string();
  std::vector<const char*> words{
      "swathplan",    "compare", file.c_str(),  "--planners", command.planners.c_str(),
      "--resolution", "0.5",     "--vehicle",   "small-usv",  "--clearance",
      "1.5",          "-o",      folder.c_str()};
  if (command.quiet) {
    words.push_back("--quiet");
  } else {
    fmt::print(stderr, "{}\n", fmt::join(words, " "));
  }
  run_commands("", {}, {command.compare}, static_cast<int>(words.size()), words.data());
  if (!command.quiet) {
    fmt::print("Open this page in a browser: {}\n",
               std::filesystem::absolute(command.folder / "report.html").string());
  }
}

}  // namespace

Command demo_command(Command compare) {
  auto command = std::make_shared<DemoCommand>();
  command->compare = std::move(compare);
  return {"demo",
          "Plan the harbour that comes with the program, with four planners",
          {path("-o,--output", "", command->folder, "Folder for the results", ""),
           text("--planners", "", command->planners, "Names, separated by commas", ""),
           flag("--quiet", "", command->quiet, "Print nothing but errors", "")},
          [command] { run(*command); },
          {}};
}

}  // namespace swathplan
