#include <memory>

#include "apps/commands.h"
#include "apps/package/bash_completion.h"
#include "apps/package/man_pages.h"
#include "io/files/atomic_file.h"

namespace swathplan {
namespace {

struct ManCommand {
  std::filesystem::path folder;
  std::string what;
  std::vector<Command> commands;
};

void run(const ManCommand& command) {
  const std::filesystem::path pages = command.folder / "man1";
  const std::filesystem::path completions = command.folder / "completions";
  std::filesystem::create_directories(pages);
  std::filesystem::create_directories(completions);
  for (const WrittenPage& page : man_pages(command.what, SWATHPLAN_VERSION, command.commands)) {
    write_text_atomically(pages / page.name, page.text);
  }
  write_text_atomically(completions / "swathplan", bash_completion(command.commands));
}

}  // namespace

Command man_command(const std::string& what, const std::vector<Command>& commands) {
  auto command = std::make_shared<ManCommand>();
  command->what = what;
  command->commands = commands;
  return {"man",
          "Write the manual pages and the bash completion, for the package",
          {required(path("-o,--output", "", command->folder, "Folder for the files", ""))},
          [command] { run(*command); },
          {},
          true};
}

}  // namespace swathplan
