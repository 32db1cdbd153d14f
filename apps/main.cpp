#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>
#include <system_error>

#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outlets/streams.h"
#include "mesh/base/allocator.h"
#include "mesh/base/error.h"
#include "mesh/base/watch.h"

namespace {

constexpr int kDataError = 1;
constexpr int kUsageError = 2;
constexpr int kPredictedToFail = 3;
constexpr int kEnded = 130;

int complain(const std::string& what, int code) {
  fmt::print(stderr, "swathplan: {}\n", what);
  return code;
}

constexpr const char* kWhat =
    "Offline hydrographic survey designer: plans routes and predicts their coverage.";

std::vector<swathplan::Command> all_commands() {
  using namespace swathplan;
  std::vector<Command> commands{
      inspect_command(), synth_command(), plan_command(),
      compare_command(), lines_command(), score_command(),
      export_command(),  adapt_command(), demo_command(compare_command())};
  commands.push_back(man_command(kWhat, commands));
  return commands;
}

/// Runs the command that was typed. Results that cannot be printed count as an error.
int run(int argc, char** argv) {
  int code = 0;
  try {
    code = swathplan::run_commands(kWhat, swathplan::version_text, all_commands(), argc, argv);
  } catch (const std::system_error& e) {
    if (std::ferror(stdout) != 0) swathplan::throw_unprinted(e.code().message());
    throw;
  }
  swathplan::finish_stdout();
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  swathplan::keep_freed_memory();
  swathplan::prepare_streams();
  try {
    return run(argc, argv);
  } catch (const swathplan::UsageError& e) {
    return complain(swathplan::in_flags(e), kUsageError);
  } catch (const swathplan::PredictedToFail& e) {
    return complain(e.what(), kPredictedToFail);
  } catch (const swathplan::EndedEarly& e) {
    return complain(e.what(), kEnded);
  } catch (const std::bad_alloc&) {
    return complain("not enough memory; use a coarser --resolution or a smaller --area",
                    kDataError);
  } catch (const std::exception& e) {
    return complain(swathplan::in_flags(e), kDataError);
  }
}
