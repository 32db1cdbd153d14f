#pragma once

#include <string>

namespace swathplan {

/// Makes the program's own streams safe, before anything else is done:
/// - A closed one is opened on /dev/null. Otherwise the next file would take its number, and
///   messages would be written into results.
/// - stderr takes what cannot be written without an error: messages that nobody can read must not
///   end a survey half way.
/// - A pipe that nobody reads any more, or a file that grows beyond the system's limit, gives an
///   error instead of ending the program.
void prepare_streams();

/// Writes what stdout still holds.
/// @throws InvalidInput if any of what was printed could not be written.
void finish_stdout();
/// @throws InvalidInput that says so.
[[noreturn]] void throw_unprinted(const std::string& why);

}  // namespace swathplan
